#pragma once

#include <cstddef>
#include <vector>

#include "raster/trace.h"

namespace scanlight::demo {

/// One step down a polygon, as a person takes it: an edge into its bucket, a scanline entered, a
/// pixel stored.
struct WalkStep {
    enum class Kind { edge, scanline, pixel };

    Kind kind;
    std::size_t edge = 0;  // of the edge table; after the last of them it stays there
    std::size_t line = 0;  // of the trace's scanlines
    std::size_t span = 0;  // of that scanline
    int x = 0;             // of a pixel
};

/// All of them in the order of the algorithm.
std::vector<WalkStep> walk_of(const raster::Trace& trace);

/// What a span has at a pixel: by as many increments as lie between.
raster::Trace::Numbers numbers_at(const raster::Trace::Span& span, int x);

}  // namespace scanlight::demo
