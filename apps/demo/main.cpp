#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "apps/demo/window/run_window.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/read_scene.h"

namespace {

using scanlight::apps::window::WindowOptions;

constexpr scanlight::raster::Viewport usual_canvas{960, 720};

int run(int argc, char** argv) {
    CLI::App program("Scanlight's demo: the scanline renderer, live.", "scanlight-demo");
    WindowOptions options;
    options.scene.size = usual_canvas;
    scanlight::apps::add_scene_options(program, options.scene);
    scanlight::apps::add_canvas_options(program, options.scene);
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
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    if (options.scene.objects.empty()) scanlight::apps::set_input(options.scene, "teapot");
    return scanlight::apps::window::run_window(options);
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
