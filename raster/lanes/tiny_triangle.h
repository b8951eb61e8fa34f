#pragma once

#include "raster/lanes/one_triangle.h"
#include "raster/lanes/waiting_pixels.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// How many rows of a tiny box hold pixels.
inline std::size_t tiny_row_count(std::uint32_t pixels) {
    const std::uint32_t pairs = pixels | pixels >> 1;
    return static_cast<std::size_t>(std::popcount((pairs | pairs >> 2) & 0x11111111u));
}

/// Tests the pixels of one tiny triangle one by one; those that pass wait for their numbers.
template <class Keep>
PixelCounts draw_tiny(const OneTriangle<Keep>& t, WaitingPixels<Keep>& waiting) {
    const DepthPlane plane = t.depth_plane();
    const int x = t.x_begin();
    const int y = t.y_begin();
    const std::int64_t z = t.depth_at(x, y);
    const Rows rows = t.band.rows();
    const PixelPlace first = t.band.row(rows.y_begin);
    const auto pixels = static_cast<std::uint32_t>(t.t.pixels[t.lane]);
    std::size_t passed = 0;
    waiting.make_room(tiny_columns * tiny_rows);
    for (std::uint32_t left = pixels; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const int i = bit % tiny_columns;
        const int j = bit / tiny_columns;
        const Depth d = Ramp{z + i * plane.dx + j * plane.dy, 0}.get();
        const std::ptrdiff_t place = (y + j - rows.y_begin) * t.band.stride() + x + i;
        if (!is_seen(d, t.own, t.keep, first + place)) continue;
        first.depth[place] = d;
        waiting.add(place, t.own, [&](int k) {
            return OneTriangle<Keep>::Values::attribute_at(t.attributes, k, t.lane, x + i, y + j);
        });
        ++passed;
    }
    return {tiny_row_count(pixels), static_cast<std::size_t>(std::popcount(pixels)), passed};
}

}  // namespace scanlight::raster::HWY_NAMESPACE
