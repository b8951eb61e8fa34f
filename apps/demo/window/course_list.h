#pragma once

#include <map>
#include <string>

#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

// Where each control stands is noted by its name.

/// The list of lessons, the free view before them; `width` in pixels.
WindowState draw_course_list(WindowState state, float width, std::map<std::string, Box>& places);

/// What leads to the other language.
WindowState draw_language(WindowState state, std::map<std::string, Box>& places);

}  // namespace scanlight::apps::window
