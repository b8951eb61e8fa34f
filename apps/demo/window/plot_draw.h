#pragma once

#include "apps/demo/screen.h"
#include "apps/demo/texts.h"
#include "apps/demo/window/box.h"

namespace scanlight::apps::window {

/// A plot of a lesson, with ImGui's background list, in that box of the window.
void draw_plot(const demo::Plot& plot, const std::string& lesson, demo::Language language,
               const Box& box);

}  // namespace scanlight::apps::window
