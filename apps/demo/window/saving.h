#pragma once

#include <string>

#include "apps/demo/window/lesson_state.h"
#include "apps/demo/window/painter.h"

namespace scanlight::apps::window {

/// What a file is named for: "teapot" of "shape:teapot", "torus" of "torus:48,24", "bunny" of
/// "meshes/bunny.obj"; "picture" of what has no name.
std::string stem_of(std::string input);

/// A file beside which the program runs, named for what is shown, that is not there yet:
/// "teapot.png", "teapot-2.png". `ending` is ".png".
std::string free_path(const SceneOptions& options, const std::string& ending);

// Each returns what was done, for a person. Throws ImageError or UsageError.

std::string save_lesson(const demo::Screen& screen, const LessonState& state);
std::string save_picture(const Pixels& pixels, const SceneOptions& options);
std::string save_scene(const SceneOptions& options);

}  // namespace scanlight::apps::window
