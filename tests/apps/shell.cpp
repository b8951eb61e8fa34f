#include "tests/apps/shell.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace scanlight::apps {

namespace {

std::string quoted(const std::string& path) {
    return "'" + path + "'";
}

int status_of(int wait_status) {
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

}  // namespace

Shell::Shell() {
    const auto program_folder = std::filesystem::path(SCANLIGHT_PROGRAM).parent_path().string();
    put(streams_ / "begin",
        "PATH=" + quoted(program_folder) + ":$PATH\nunset CI SCANLIGHT_ACCEPT\n");
}

Outcome Shell::run(const std::string& command_line) const {
    const std::string script = ". " + quoted(streams_ / "begin") + " && cd " +
                               quoted(folder_ / "") + " && { " + command_line + "\n} </dev/null >" +
                               quoted(streams_ / "out") + " 2>" + quoted(streams_ / "err");
    Outcome outcome;
    outcome.status = status_of(std::system(script.c_str()));
    outcome.out = contents_of(streams_ / "out");
    outcome.err = contents_of(streams_ / "err");
    return outcome;
}

bool Shell::has(const std::string& name) const {
    return std::filesystem::exists(folder_ / name);
}

bool is_one_complaint(const std::string& err) {
    return err.starts_with("scanlight: ") && std::count(err.begin(), err.end(), '\n') == 1 &&
           err.back() == '\n';
}

}  // namespace scanlight::apps
