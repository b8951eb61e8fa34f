#pragma once

#include <string>

#include "apps/demo/code_at_work.h"
#include "apps/demo/window/box.h"

namespace scanlight::apps::window {

/// Lines of the source by ImGui, in that box of the window; those at work stand out.
void draw_code(const demo::Excerpt& excerpt, const std::string& title, const Box& box);

}  // namespace scanlight::apps::window
