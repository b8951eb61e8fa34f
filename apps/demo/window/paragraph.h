#pragma once

#include <string>

namespace scanlight::apps::window {

/// Text over as many lines as it takes; what follows a _ is low: I_a.
void draw_paragraph(const std::string& text);

}  // namespace scanlight::apps::window
