#include "apps/demo/window_program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "apps/demo/window/window_options.h"

namespace scanlight::demo {

namespace {

int report(const std::string& message) {
    std::fprintf(stderr, "scanlight-demo: %s\n", message.c_str());
    return 2;
}

}  // namespace

int run_window_program(int argc, const char* const* argv) {
    CLI::App program("Scanlight's live window.", "scanlight-demo");
    apps::window::WindowOptions options;
    apps::window::add_window_options(program, options);
    try {
        program.parse(argc, argv);
        return apps::window::run_window(apps::window::completed(options));
    } catch (const CLI::ParseError& error) {
        return report(std::string(error.what()) + "; see scanlight-demo --help");
    } catch (const std::exception& error) {
        return report(error.what());
    }
}

}  // namespace scanlight::demo
