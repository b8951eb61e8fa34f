#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "apps/demo/screen.h"

namespace scanlight::demo {

// Where all that a plot consists of stands, in pixels from its upper left corner: for whoever draws
// it, as SVG or in a window.

struct PlotLine {
    enum class Kind { grid, axis, here };
    Kind kind = Kind::grid;
    glm::dvec2 from, to;
};

/// Words beside a place: they begin, have their middle or end there, on this baseline.
struct PlotWords {
    enum class Anchor { start, middle, end };
    Anchor anchor = Anchor::start;
    glm::dvec2 at;
    std::string words;  // {{key}} is a text
};

/// A curve, in pieces where it breaks off.
struct PlotCurve {
    std::string key;
    std::vector<std::vector<glm::dvec2>> pieces;
    PlotLine sample;  // beside its name
};

struct PlotLayout {
    std::vector<PlotLine> lines;
    std::vector<PlotWords> words;
    std::vector<PlotCurve> curves;
};

/// `size` in pixels; less than about 200 x 130 leaves no room.
PlotLayout plot_layout(const Plot& plot, const glm::dvec2& size);

}  // namespace scanlight::demo
