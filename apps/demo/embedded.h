#pragma once

#include <string_view>

namespace scanlight::demo::embedded {

// Files that the program brings along.

extern const std::string_view texts;         // texts.toml
extern const std::string_view index;         // page/index.html
extern const std::string_view style;         // page/page.css
extern const std::string_view page_script;   // page/page.js
extern const std::string_view steps_script;  // page/stepper.js
extern const std::string_view panes;         // scenes/panes.toml
extern const std::string_view fill;          // raster/fill.h
extern const std::string_view scan_convert;  // raster/scan_convert.h
extern const std::string_view fragments;     // raster/fragments.h

}  // namespace scanlight::demo::embedded
