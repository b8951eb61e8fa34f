#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <tuple>
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

/// A coordinate or a depth along a line, at the centres of the columns (or rows) it passes. A line
/// ends between two centres: what would lie beyond is held at the end.
class LineRamp {
public:
    /// From `from` to `to` over `length` > 0, beginning `offset` after `from`; both in 1/256 pixel.
    LineRamp(std::int64_t from, std::int64_t to, std::int64_t offset, std::int64_t length)
        : low_(std::min(from, to) << ramp_bits), high_(std::max(from, to) << ramp_bits) {
        const std::int64_t change = (to - from) << ramp_bits;
        ramp_ = {(from << ramp_bits) + change * offset / length, change * subpixels / length};
    }

    void step() { ramp_.step(); }
    std::int32_t get() const { return Ramp{std::clamp(ramp_.value, low_, high_), 0}.get(); }

private:
    std::int64_t low_, high_;
    Ramp ramp_;
};

/// One pixel for each column (flat lines) or row (steep ones) between two points, both ends
/// included, by the digital differential analyser: the other coordinate and the depth step by a
/// constant. The same pixels from a to b as from b to a. Calls `emit(LinePixel)`; pixels outside
/// the picture are left out.
template <class Emit>
void draw_line(ScreenVertex<0> a, ScreenVertex<0> b, Viewport viewport, Emit&& emit) {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const auto major = [steep](const ScreenVertex<0>& v) { return steep ? v.y : v.x; };
    const auto minor = [steep](const ScreenVertex<0>& v) { return steep ? v.x : v.y; };
    if (std::tuple(major(a), minor(a), a.z) > std::tuple(major(b), minor(b), b.z)) std::swap(a, b);

    const int first = major(a) >> subpixel_bits;
    const int last = major(b) >> subpixel_bits;
    const int offset = first * subpixels + half_pixel - major(a);
    const int length = std::max(major(b) - major(a), 1);
    LineRamp across(minor(a), minor(b), offset, length);
    LineRamp depth(a.z, b.z, offset, length);
    for (int along = first; along <= last; ++along, across.step(), depth.step()) {
        const int other = across.get() >> subpixel_bits;
        const LinePixel pixel{steep ? other : along, steep ? along : other, depth.get()};
        if (pixel.x >= 0 && pixel.x < viewport.width && pixel.y >= 0 && pixel.y < viewport.height) {
            emit(pixel);
        }
    }
}

}  // namespace scanlight::raster
