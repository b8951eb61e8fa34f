#pragma once

#include <algorithm>
#include <array>

#include "raster/crossing.h"
#include "raster/lanes/one_triangle.h"
#include "raster/lanes/spans.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// One large triangle with a plane: down its left and its right edge, row by row, each row a long
/// span. The same pixels as the walk by edge table finds, whose table of three edges needs no
/// bookkeeping: one edge goes from the top corner to the bottom one, the others meet at the middle.
template <class Keep>
class LargeTriangle {
public:
    LargeTriangle(const OneTriangle<Keep>& triangle, std::array<ScreenPoint, 3> corners)
        : t_(triangle), corners_(corners) {
        std::ranges::sort(corners_, [](const auto& a, const auto& b) { return a.y < b.y; });
    }

    PixelCounts draw() {
        const auto& [top, middle, bottom] = corners_;
        draw_between(top, bottom, top, middle);
        draw_between(top, bottom, middle, bottom);
        return counts_;
    }

private:
    /// The rows of the short edge, from the one edge to the other.
    void draw_between(ScreenPoint long_top, ScreenPoint long_bottom, ScreenPoint short_top,
                      ScreenPoint short_bottom) {
        const int y_begin = std::max(first_centre(short_top.y), t_.band.rows().y_begin);
        const int y_end = std::min(first_centre(short_bottom.y), t_.band.rows().y_end);
        if (y_begin >= y_end) return;
        Crossing a(long_top, long_bottom, y_begin);
        Crossing b(short_top, short_bottom, y_begin);
        for (int y = y_begin; y < y_end; ++y) {
            draw_row(y, std::min(a.column(), b.column()), std::max(a.column(), b.column()));
            a.step();
            b.step();
        }
    }

    void draw_row(int y, int x_begin, int x_end) {
        if (x_begin == x_end) return;
        const std::int64_t dx = t_.depth_plane().dx;
        const int x = first_vector(x_begin, x_end);
        RampLanes z(Ramp{t_.depth_at(x, y), dx}, 0);
        typename OneTriangle<Keep>::Values values(t_.attributes, t_.lane, x, y);
        values.step_right(t_.attributes, t_.lane);
        const std::size_t passed =
            draw_span(t_.band.row(y), x_begin, x_end, z, values, t_.keep, Ints(t_.own));
        counts_ += {1, static_cast<std::size_t>(x_end - x_begin), passed};
    }

    const OneTriangle<Keep> t_;
    std::array<ScreenPoint, 3> corners_;  // from top to bottom
    PixelCounts counts_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
