#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "raster/crossing.h"
#include "raster/fill.h"
#include "raster/rows.h"

namespace scanlight::raster {

/// A triangle on the screen that is counted, not seen.
struct CountedTriangle {
    std::array<ScreenVertex<0>, 3> corners;
    std::int32_t count = 0;  // where it runs counter-clockwise on the screen; else its negative
};

/// What is counted against, and where: from the first pixel of the first of some rows on.
struct CountedBand {
    Rows rows;
    std::ptrdiff_t stride;  // from a row to the next
    const Depth* depth;
    std::int32_t* counts;
};

namespace detail {

inline void count_row(const CountedBand& band, int y, int x_begin, int x_end, Ramp depth,
                      std::int32_t count) {
    const std::ptrdiff_t row = band.stride * (y - band.rows.y_begin);
    for (int x = x_begin; x < x_end; ++x, depth.step())
        band.counts[row + x] += depth.get() < band.depth[row + x] ? count : 0;
}

/// The rows of the short edge, from the one edge to the other.
template <class Visit>
void visit_rows(ScreenPoint long_top, ScreenPoint long_bottom, ScreenPoint short_top,
                ScreenPoint short_bottom, Rows rows, Visit&& visit) {
    const int y_begin = std::max(first_centre(short_top.y), rows.y_begin);
    const int y_end = std::min(first_centre(short_bottom.y), rows.y_end);
    if (y_begin >= y_end) return;
    Crossing a(long_top, long_bottom, y_begin);
    Crossing b(short_top, short_bottom, y_begin);
    for (int y = y_begin; y < y_end; ++y) {
        const int begin = std::min(a.column(), b.column());
        const int end = std::max(a.column(), b.column());
        if (begin < end) visit(y, begin, end);
        a.step();
        b.step();
    }
}

}  // namespace detail

/// Adds the count of a triangle to all pixels of a band that it covers and where it is nearer than
/// their depth: what `PolygonFiller` by the winding rule and `count_span` do, without a table for
/// three edges. Most sides of shadow volumes are slivers, a pixel or two wide.
class TriangleCounter {
public:
    void count(const CountedTriangle& triangle, const CountedBand& band) {
        const auto& [a, b, c] = triangle.corners;
        const auto setup = plane_setup({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        const auto plane = setup ? depth_plane(*setup, a.z, b.z, c.z) : std::nullopt;
        if (!plane) return walk(triangle, band);
        // The inverse of an area that is positive for triangles that run clockwise.
        const std::int32_t count = setup->inverse_area > 0.0 ? -triangle.count : triangle.count;
        std::array<ScreenPoint, 3> corners{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}};
        std::ranges::sort(corners, {}, &ScreenPoint::y);
        const auto& [top, middle, bottom] = corners;
        const auto row = [&](int y, int x_begin, int x_end) {
            const int i = x_begin - (a.x >> subpixel_bits);
            const int j = y - (a.y >> subpixel_bits);
            detail::count_row(band, y, x_begin, x_end, {plane->at(i, j), plane->dx}, count);
        };
        detail::visit_rows(top, bottom, top, middle, band.rows, row);
        detail::visit_rows(top, bottom, middle, bottom, band.rows, row);
    }

private:
    void walk(const CountedTriangle& triangle, const CountedBand& band) {
        const auto emit = [&](const Span<0>& span) {
            detail::count_row(band, span.y, span.x_begin, span.x_end, span.ramps.depth,
                              span.winding * triangle.count);
        };
        filler_.fill(triangle.corners, Interpolation::planar, emit, NoObserver{}, band.rows);
    }

    PolygonFiller<0, FillRule::winding> filler_;
};

}  // namespace scanlight::raster
