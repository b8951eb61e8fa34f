#include "apps/demo/parse_and_act.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

namespace scanlight::demo {

namespace {

int report(const std::string& message) {
    std::fprintf(stderr, "scanlight-demo: %s\n", message.c_str());
    return exit_error;
}

int guarded(CLI::App& program, int argc, const char* const* argv, const std::function<int()>& act) {
    try {
        program.parse(argc, argv);
        return act();
    } catch (const CLI::Success& wanted) {  // --help, --version
        return program.exit(wanted);
    } catch (const CLI::ParseError& error) {
        return report(std::string(error.what()) + "; see scanlight-demo --help");
    } catch (const std::bad_alloc&) {
        return report("out of memory");
    } catch (const std::exception& error) {
        return report(error.what());
    }
}

/// Whether all that was printed has arrived: a full disk or a closed pipe is an error too.
bool standard_output_took_all() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int parse_and_act(CLI::App& program, int argc, const char* const* argv,
                  const std::function<int()>& act) {
    const int status = guarded(program, argc, argv, act);
    if (status == exit_error || standard_output_took_all()) return status;
    return report("standard output: cannot be written");
}

}  // namespace scanlight::demo
