#pragma once

#include "raster/ramp.h"

namespace scanlight::raster {

/// A run of pixels [x_begin, x_end) of scanline y inside a polygon, with what to interpolate along
/// it: values at the centre of pixel x_begin, steps from pixel to pixel.
template <int N>
struct Span {
    int y = 0;
    int x_begin = 0;
    int x_end = 0;
    Ramps<N> ramps;
    int winding = 1;  // how often the outline goes round it, under `FillRule::winding`
};

}  // namespace scanlight::raster
