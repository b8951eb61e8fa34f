#include "apps/scanlight/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "apps/scanlight/commands.h"

namespace scanlight::apps {

namespace {

constexpr int exit_ok = 0;
constexpr int exit_difference = 1;
constexpr int exit_error = 2;

void add_commands(CLI::App& program) {
    program.set_version_flag("--version", std::string("scanlight ") + SCANLIGHT_VERSION);
    program.require_subcommand(1);
    program.get_formatter()->column_width(38);
    program.footer(
        "Examples:\n"
        "  scanlight render teapot                     a built-in shape into teapot.png\n"
        "  scanlight bunny.obj bunny.png               a mesh file into a picture\n"
        "  scanlight render bunny.obj -o - | display   a PPM to a pipe\n"
        "  scanlight steps shape:star                  watch the edge table work\n"
        "  scanlight diff a.png b.png                  exit status 1 if they differ\n"
        "  scanlight COMMAND --help                    all options of a command");
    add_render_command(program);
    add_info_command(program);
    add_diff_command(program);
    add_grade_command(program);
    add_steps_command(program);
    add_gallery_command(program);
    add_shapes_command(program);
    add_turntable_command(program);
    add_scene_command(program);
    for (CLI::App* command : program.get_subcommands({})) {
        command->set_version_flag("--version", program.version());
    }
}

bool is_command(const CLI::App& program, const std::string& word) {
    const auto is_named = [&](const CLI::App* command) { return command->get_name() == word; };
    return !program.get_subcommands(is_named).empty();
}

/// `scanlight IN OUT` means `scanlight render IN OUT`.
std::vector<std::string> with_command(const CLI::App& program, std::vector<std::string> arguments) {
    if (arguments.empty()) return {"--help"};
    const std::string& first = arguments.front();
    const bool is_option = first.size() > 1 && first.front() == '-';
    if (!is_option && !is_command(program, first)) arguments.insert(arguments.begin(), "render");
    return arguments;
}

int report(const std::string& message) {
    std::fprintf(stderr, "scanlight: %s\n", message.c_str());
    return exit_error;
}

/// Whether all that was printed has arrived: a full disk or a closed pipe is an error too.
bool standard_output_took_all() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

int parse_and_run(CLI::App& program, std::vector<std::string> arguments) {
    arguments = with_command(program, std::move(arguments));
    const std::string command =
        is_command(program, arguments.front()) ? arguments.front() + " " : "";
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them last first
    try {
        program.parse(arguments);
    } catch (const CLI::Success& wanted) {  // --help, --version
        return program.exit(wanted);
    } catch (const CLI::ParseError& error) {
        return report(std::string(error.what()) + "; see scanlight " + command + "--help");
    }
    return exit_ok;
}

int guarded_run(CLI::App& program, std::vector<std::string> arguments) {
    try {
        return parse_and_run(program, std::move(arguments));
    } catch (const Dissimilar&) {
        return exit_difference;
    } catch (const std::bad_alloc&) {
        return report("out of memory");
    } catch (const std::exception& error) {
        return report(error.what());
    }
}

}  // namespace

int run(int argc, const char* const* argv) {
    CLI::App program("Scanlight: the scanline renderer that teaches.", "scanlight");
    add_commands(program);
    const int status = guarded_run(program, {argv + 1, argv + argc});
    if (status == exit_error || standard_output_took_all()) return status;
    return report("standard output: cannot be written");
}

}  // namespace scanlight::apps
