#pragma once

#include "raster/lanes/numbers.h"
#include "raster/polygon_streams.h"
#include "raster/visible_band.h"

namespace scanlight::raster::HWY_NAMESPACE {

// Early rejection, a band at a time (Greene, Kass & Miller 1993, "Hierarchical Z-buffer
// visibility", SIGGRAPH, with one level): a polygon behind the farthest thing seen in a band is not
// drawn there. The farthest is looked for only after a large polygon came to nothing, so that
// scenes without hidden polygons, or with the nearest drawn last, never pay for it.

/// Of the depths in a band.
inline Depth farthest_depth(VisibleBand& band) {
    Ints farthest(0);
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        const Depth* row = band.depth_row(y);
        int x = 0;
        for (; x + lane_count <= band.width(); x += lane_count)
            farthest = max(farthest, load(row + x));
        const Mask left = first_lanes(band.width() - x);
        farthest = max(farthest, select(left, load(row + x), Ints(0)));
    }
    Depth lanes[lane_count];
    store(farthest, lanes);
    for (const Depth depth : lanes)
        lanes[0] = lanes[0] < depth ? depth : lanes[0];
    return lanes[0];
}

/// Takes note of a polygon that was drawn.
inline void look_behind(VisibleBand& band, const PixelCounts& drawn) {
    const bool pays = drawn.passed == 0 && 4 * drawn.tested > band.pixels();
    if (pays && band.farthest_may_change()) band.set_farthest(farthest_depth(band));
}

/// Whether a face lies behind all that a band shows. Corners that clipping makes between its own
/// are floats, off by some 2^-23.
inline bool is_hidden(const PolygonStreams& polygons, std::size_t face, const VisibleBand& band) {
    constexpr Depth roundings = 1 << 12;
    constexpr std::int32_t before_near = outside_bit(ClipPlane::near);  // has no depth
    if (band.farthest() == behind_everything) return false;
    for (const std::uint32_t v : polygons.face(face)) {
        const bool has_depth = (polygons.outside[v] & before_near) == 0;
        if (!has_depth || polygons.z[v] - roundings < band.farthest()) return false;
    }
    return true;
}

}  // namespace scanlight::raster::HWY_NAMESPACE
