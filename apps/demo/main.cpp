#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "apps/demo/window/window_options.h"

namespace {

int run(int argc, char** argv) {
    using namespace scanlight::apps::window;
    CLI::App program("Scanlight's demo: the scanline renderer, live.", "scanlight-demo");
    WindowOptions options;
    add_window_options(program, options);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    return run_window(completed(options));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "scanlight-demo: %s\n", error.what());
        return 2;
    }
}
