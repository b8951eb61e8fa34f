#pragma once

#include <cstdint>

#include "raster/crossing.h"

namespace scanlight::raster {

/// One polygon edge on its way down the screen.
/// Invariant: `crossing` and `values` belong to the centre line of the current scanline.
/// `Values` is what an interpolation carries down each edge; nothing for a plane equation.
template <class Values>
struct Edge {
    int y_begin = 0;  // first scanline whose centre the edge crosses
    int y_end = 0;    // one past the last; half-open, so neighbours never share a pixel
    Crossing crossing;
    Values values;
    std::uint32_t index = 0;   // the polygon's edge from corner `index` to the next
    std::int32_t winding = 1;  // of the outline: 1 where it runs down this edge, -1 where up

    void step() {
        crossing.step();
        values.step();
    }
};

}  // namespace scanlight::raster
