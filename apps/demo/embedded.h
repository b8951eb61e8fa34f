#pragma once

#include <string_view>

namespace scanlight::demo::embedded {

// Files of this folder that the program brings along.

extern const std::string_view texts;         // texts.toml
extern const std::string_view index;         // page/index.html
extern const std::string_view style;         // page/page.css
extern const std::string_view page_script;   // page/page.js
extern const std::string_view steps_script;  // page/stepper.js
extern const std::string_view panes;         // scenes/panes.toml

}  // namespace scanlight::demo::embedded
