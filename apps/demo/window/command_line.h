#pragma once

#include <string>

#include "apps/scene/scene_options.h"

namespace scanlight::apps::window {

/// What to type for the same picture, to the bit: `scanlight render` with its options, or, of
/// scenes that take more than options, with a scene file in the same line. Throws UsageError for a
/// mesh from standard input.
std::string command_line_of(const SceneOptions& options);

/// What follows `scanlight render` in the former; empty where options do not tell all.
std::string arguments_of(const SceneOptions& options);

}  // namespace scanlight::apps::window
