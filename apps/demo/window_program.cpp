#include "apps/demo/window_program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "apps/demo/window/run_window.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/read_scene.h"

namespace scanlight::demo {

namespace {

using apps::window::WindowOptions;

constexpr raster::Viewport usual_canvas{960, 720};

void add_options(CLI::App& program, WindowOptions& options) {
    apps::add_scene_options(program, options.scene);
    apps::add_canvas_options(program, options.scene);
    program.get_option("input")->required(false);
    program
        .add_option("--measure", options.measured_frames,
                    "turn the picture by so many frames, print how long they took, and end")
        ->type_name("FRAMES")
        ->check(CLI::Range(1, 100000));
    program.add_option("--snapshot", options.snapshot, "save a picture of the window, and end")
        ->type_name("PNG");
    program.add_flag("--controls", options.lists_controls,
                     "print where each control of the window stands, for scripts, and end");
}

int report(const std::exception& error) {
    std::fprintf(stderr, "scanlight-demo: %s\n", error.what());
    return 2;
}

}  // namespace

int run_window_program(int argc, const char* const* argv) {
    CLI::App program("Scanlight's live window.", "scanlight-demo");
    WindowOptions options;
    options.scene.size = usual_canvas;
    add_options(program, options);
    try {
        program.parse(argc, argv);
        if (options.scene.objects.empty()) apps::set_input(options.scene, "teapot");
        return apps::window::run_window(options);
    } catch (const std::exception& error) {
        return report(error);
    }
}

}  // namespace scanlight::demo
