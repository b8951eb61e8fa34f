#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "raster/clip.h"
#include "raster/fixed.h"
#include "raster/project.h"
#include "raster/ramp.h"

namespace scanlight::raster {

struct LinePixel {
    int x;
    int y;
    Depth depth;
};

/// The part of a line inside the view volume, by the same crossings as polygons have.
inline std::optional<std::pair<ClipVertex<0>, ClipVertex<0>>> clip_line(ClipVertex<0> a,
                                                                        ClipVertex<0> b) {
    for (const ClipPlane plane : clip_planes) {
        const bool a_inside = distance(a.position, plane) >= 0.0f;
        const bool b_inside = distance(b.position, plane) >= 0.0f;
        if (!a_inside && !b_inside) return std::nullopt;
        if (!b_inside) b = crossing(a, b, plane);
        if (!a_inside) a = crossing(b, a, plane);
    }
    return std::pair(a, b);
}

/// One pixel for each column (flat lines) or row (steep ones) between two points, both ends
/// included, by the digital differential analyser: the other coordinate and the depth step by a
/// constant. The same pixels from a to b as from b to a. Calls `emit(LinePixel)`; pixels outside
/// the picture are left out.
template <class Emit>
void draw_line(ScreenVertex<0> a, ScreenVertex<0> b, Viewport viewport, Emit&& emit) {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const auto major = [steep](const ScreenVertex<0>& v) { return steep ? v.y : v.x; };
    const auto minor = [steep](const ScreenVertex<0>& v) { return steep ? v.x : v.y; };
    if (std::pair(major(a), minor(a)) > std::pair(major(b), minor(b))) std::swap(a, b);

    const std::int64_t length = std::max(major(b) - major(a), 1);
    const int first = major(a) >> subpixel_bits;
    const int last = major(b) >> subpixel_bits;
    const auto ramp = [&](std::int64_t from, std::int64_t to) {
        const std::int64_t change = (to - from) << ramp_bits;
        return Ramp{from << ramp_bits, change * subpixels / length};
    };
    Ramp across = ramp(minor(a), minor(b));
    Ramp depth = ramp(a.z, b.z);
    for (int along = first; along <= last; ++along, across.step(), depth.step()) {
        const int other = across.get() >> subpixel_bits;
        const LinePixel pixel{steep ? other : along, steep ? along : other,
                              std::clamp(depth.get(), 0, depth_far)};
        if (pixel.x >= 0 && pixel.x < viewport.width && pixel.y >= 0 && pixel.y < viewport.height) {
            emit(pixel);
        }
    }
}

}  // namespace scanlight::raster
