#pragma once

#include <string>

namespace scanlight::apps::window {

/// A formula of the course, by ImGui, in as many lines as it has.
void draw_formula(const std::string& mathml);

}  // namespace scanlight::apps::window
