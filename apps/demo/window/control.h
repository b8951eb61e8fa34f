#pragma once

#include <optional>

#include "apps/demo/window/box.h"
#include "apps/demo/window/parameters.h"

namespace scanlight::apps::window {

/// Draws the control of a parameter, as wide as there is room. What a person made of the value, if
/// anything.
std::optional<Value> draw_control(const Parameter& parameter, const std::optional<Value>& value);

/// Where the last thing said to ImGui stands in the window.
Box place_of_item();

/// "I_a K_a" with both a lowered: what follows a line is, as far as letters and digits go.
void draw_symbol(const std::string& symbol);

}  // namespace scanlight::apps::window
