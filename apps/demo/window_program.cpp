#include "apps/demo/window_program.h"

#include <CLI/CLI.hpp>

#include "apps/demo/parse_and_act.h"
#include "apps/demo/window/window_options.h"

namespace scanlight::demo {

int run_window_program(int argc, const char* const* argv) {
    CLI::App program("Scanlight's live window.", "scanlight-demo");
    apps::window::WindowOptions options;
    apps::window::add_window_options(program, options);
    return parse_and_act(program, argc, argv, [&] {
        return apps::window::run_window(apps::window::completed(options));
    });
}

}  // namespace scanlight::demo
