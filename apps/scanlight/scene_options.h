#pragma once

#include <string>

#include "apps/scene/scene_options.h"

namespace CLI {
class App;
}

namespace scanlight::apps {

/// The options that a command line gives, such as "teapot --shading flat": one picture's source.
SceneOptions parse_scene(const std::string& command_line);

/// Adds the options that say what each polygon looks like to a subcommand; `options` is filled as
/// the command line is parsed, and must outlive `app`. A scene file is read as soon as it is met,
/// and the other options come over what it says.
void add_scene_options(CLI::App& app, SceneOptions& options);

/// Adds what a picture shows beside its polygons: their edges, and what lies behind.
void add_canvas_options(CLI::App& app, SceneOptions& options);

}  // namespace scanlight::apps
