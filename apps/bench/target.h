#pragma once

#include <algorithm>

#include "raster/framebuffer.h"

namespace scanlight::bench {

/// Depth and colour to draw into. The library's depth is an integer; the methods that evaluate in
/// floating point have a depth of their own kind, so that none pays for a conversion.
template <class Z>
struct Target {
    explicit Target(raster::Viewport size)
        : depth(size, behind_everything), color(size, raster::Rgba(0.0f)) {}

    void clear() {
        for (int y = 0; y < depth.height(); ++y) {
            std::ranges::fill(depth.row(y), behind_everything);
            std::ranges::fill(color.row(y), raster::Rgba(0.0f));
        }
    }

    raster::Plane<Z> depth;
    raster::Plane<raster::Rgba> color;

private:
    static constexpr Z behind_everything = static_cast<Z>(raster::depth_clear);
};

}  // namespace scanlight::bench
