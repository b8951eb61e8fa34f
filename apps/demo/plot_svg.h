#pragma once

#include <string>

#include "apps/demo/screen.h"

namespace scanlight::demo {

/// A plot as SVG. Its words stand as {{key}}, for whoever knows the language, and its colours are
/// classes (axis, grid, here, curve c0, c1, …), for a style sheet.
std::string plot_svg(const Plot& plot);

}  // namespace scanlight::demo
