#include "apps/demo/window/window_options.h"

#include <CLI/CLI.hpp>

#include "apps/scanlight/scene_options.h"
#include "apps/scene/read_scene.h"

namespace scanlight::apps::window {

namespace {

constexpr raster::Viewport usual_canvas{960, 720};

void add_lesson_options(CLI::App& app, WindowOptions& options) {
    CLI::Option* window =
        app.add_flag("--window")->description("the window, even for what else is drawn without");
    CLI::Option* lesson = app.add_option("--lesson", options.lesson, "the lesson to open")
                              ->type_name("NAME")
                              ->needs(window);
    app.add_option("--set", options.assignments, "where one of its controls stands, repeatable")
        ->type_name("CONTROL=VALUE")
        ->allow_extra_args(false)
        ->needs(lesson);
    app.add_option("--language", options.language, "of the lessons: en or zh")
        ->type_name("en|zh")
        ->capture_default_str();
}

}  // namespace

void add_window_options(CLI::App& app, WindowOptions& options) {
    options.scene.size = usual_canvas;
    add_scene_options(app, options.scene);
    add_canvas_options(app, options.scene);
    app.get_option("input")->required(false);
    app.add_option("--measure", options.measured_frames,
                   "turn the picture by so many frames, print how long they took, and end")
        ->type_name("FRAMES")
        ->check(CLI::Range(1, 100000));
    app.add_option("--snapshot", options.snapshot, "save a picture of the window, and end")
        ->type_name("PNG");
    app.add_flag("--controls", options.lists_controls,
                 "print where each control of the window stands, for scripts, and end");
    add_lesson_options(app, options);
}

WindowOptions completed(WindowOptions options) {
    if (options.scene.objects.empty()) set_input(options.scene, "teapot");
    return options;
}

}  // namespace scanlight::apps::window
