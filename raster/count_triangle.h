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
    static constexpr int tile_bits = 6;  // columns of a tile: two to this power

    Rows rows;
    std::ptrdiff_t stride;  // from a row to the next
    const Depth* depth;
    std::int32_t* counts;
    const Depth* farthest;  // of the depths in each tile, which is as high as the band

    Depth farthest_in(int x_begin, int x_end) const {
        Depth result = 0;
        for (int tile = x_begin >> tile_bits; tile <= (x_end - 1) >> tile_bits; ++tile)
            result = std::max(result, farthest[tile]);
        return result;
    }
};

/// The rows of a triangle between two of its edges, from the upper end of the shorter one to the
/// lower.
class TrianglePart {
public:
    TrianglePart(ScreenPoint long_top, ScreenPoint long_bottom, ScreenPoint short_top,
                 ScreenPoint short_bottom, Rows rows)
        : long_{long_top, long_bottom},
          short_{short_top, short_bottom},
          rows_{std::max(first_centre(short_top.y), rows.y_begin),
                std::min(first_centre(short_bottom.y), rows.y_end)} {}

    Rows rows() const { return rows_; }
    bool empty() const { return rows_.y_begin >= rows_.y_end; }

    /// Calls `visit(y, x_begin, x_end)` for each row that has pixels.
    template <class Visit>
    void for_each_row(Visit&& visit) const {
        Crossing a = crossing(long_, rows_.y_begin);
        Crossing b = crossing(short_, rows_.y_begin);
        for (int y = rows_.y_begin; y < rows_.y_end; ++y) {
            const int begin = std::min(a.column(), b.column());
            const int end = std::max(a.column(), b.column());
            if (begin < end) visit(y, begin, end);
            a.step();
            b.step();
        }
    }

    /// The columns at both edges in row y.
    std::array<int, 2> columns(int y) const {
        return {crossing(long_, y).column(), crossing(short_, y).column()};
    }

private:
    struct Line {
        ScreenPoint top, bottom;
    };
    static Crossing crossing(const Line& line, int y) { return {line.top, line.bottom, y}; }

    Line long_, short_;
    Rows rows_;
};

/// Adds the count of a triangle to all pixels of a band that it covers and where it is nearer than
/// their depth: what `PolygonFiller` by the winding rule and `count_span` do, without a table for
/// three edges. Most sides of shadow volumes are slivers, a pixel or two wide, and most of each
/// lies behind what is seen.
class TriangleCounter {
public:
    void count(const CountedTriangle& triangle, const CountedBand& band) {
        const auto& [a, b, c] = triangle.corners;
        const auto setup = plane_setup({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        const auto plane = setup ? depth_plane(*setup, a.z, b.z, c.z) : std::nullopt;
        if (!plane) return walk(triangle, band);
        // The inverse of an area that is positive for triangles that run clockwise.
        const std::int32_t count = setup->inverse_area > 0.0 ? -triangle.count : triangle.count;
        const Depths depths{*plane, a.x >> subpixel_bits, a.y >> subpixel_bits};
        std::array<ScreenPoint, 3> corners{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}};
        std::ranges::sort(corners, {}, &ScreenPoint::y);
        const auto& [top, middle, bottom] = corners;
        count_part({top, bottom, top, middle, band.rows}, depths, count, band);
        count_part({top, bottom, middle, bottom, band.rows}, depths, count, band);
    }

private:
    struct Depths {
        DepthPlane plane;
        int reference_x, reference_y;

        Ramp ramp(int x, int y) const {
            return {plane.at(x - reference_x, y - reference_y), plane.dx};
        }
    };

    static void count_part(const TrianglePart& part, const Depths& depths, std::int32_t count,
                           const CountedBand& band) {
        if (part.empty() || is_hidden(part, depths, band)) return;
        part.for_each_row([&](int y, int x_begin, int x_end) {
            count_row(band, y, x_begin, x_end, depths.ramp(x_begin, y), count);
        });
    }

    /// Whether all of it lies behind what is seen. Depth is even: it is nearest in a corner, up to
    /// the pixel by which columns are rounded.
    static bool is_hidden(const TrianglePart& part, const Depths& depths, const CountedBand& band) {
        int x_begin = max_size;
        int x_end = 0;
        std::int64_t nearest =
            depths.ramp(part.columns(part.rows().y_begin)[0], part.rows().y_begin).value;
        for (const int y : {part.rows().y_begin, part.rows().y_end - 1}) {
            for (const int x : part.columns(y)) {
                x_begin = std::min(x_begin, x);
                x_end = std::max(x_end, x);
                nearest = std::min(nearest, depths.ramp(x, y).value);
            }
        }
        if (x_begin >= x_end) return false;  // next to nothing
        const std::int64_t slack = std::abs(depths.plane.dx);
        const std::int64_t farthest = band.farthest_in(x_begin, x_end);
        return (nearest - slack) >> ramp_bits >= farthest;  // may be no depth at all
    }

    static void count_row(const CountedBand& band, int y, int x_begin, int x_end, Ramp depth,
                          std::int32_t count) {
        const std::ptrdiff_t row = band.stride * (y - band.rows.y_begin);
        for (int x = x_begin; x < x_end; ++x, depth.step())
            band.counts[row + x] += depth.get() < band.depth[row + x] ? count : 0;
    }

    void walk(const CountedTriangle& triangle, const CountedBand& band) {
        const auto emit = [&](const Span<0>& span) {
            count_row(band, span.y, span.x_begin, span.x_end, span.ramps.depth,
                      span.winding * triangle.count);
        };
        filler_.fill(triangle.corners, Interpolation::planar, emit, NoObserver{}, band.rows);
    }

    PolygonFiller<0, FillRule::winding> filler_;
};

}  // namespace scanlight::raster
