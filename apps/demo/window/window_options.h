#pragma once

#include "apps/demo/window/run_window.h"

namespace CLI {
class App;
}

namespace scanlight::apps::window {

/// Adds the options of `scanlight render` that say what a picture shows, IN among them, and those
/// of the window. `options` is filled as the command line is parsed, and must outlive `app`.
/// Without IN it is the teapot that is seen: see `completed`.
void add_window_options(CLI::App& app, WindowOptions& options);

/// What is opened by a command line that was parsed.
WindowOptions completed(WindowOptions options);

}  // namespace scanlight::apps::window
