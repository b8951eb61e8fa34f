#pragma once

#include <algorithm>
#include <array>

#include "raster/crossing.h"
#include "raster/lanes/triangles.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// One large triangle with a plane: down its left and its right edge, row by row, each row a long
/// span. The same pixels as the walk by edge table finds, whose table of three edges needs no
/// bookkeeping: one edge goes from the top corner to the bottom one, the others meet at the middle.
class LargeTriangle {
public:
    LargeTriangle(const PreparedTriangles& t, int lane, std::array<ScreenPoint, 3> corners,
                  Item item, VisibleBand& band)
        : corners_(corners),
          plane_{t.depth[lane], t.depth_dx[lane], t.depth_dy[lane]},
          reference_x_(t.reference_x[lane]),
          reference_y_(t.reference_y[lane]),
          item_(item),
          band_(band) {
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
        const int y_begin = std::max(first_centre(short_top.y), band_.rows().y_begin);
        const int y_end = std::min(first_centre(short_bottom.y), band_.rows().y_end);
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
        const Ramp z{plane_.at(x_begin - reference_x_, y - reference_y_), plane_.dx};
        counts_ += {1, static_cast<std::size_t>(x_end - x_begin),
                    draw_span(band_.depth_row(y), band_.item_row(y), x_begin, x_end, z, item_)};
    }

    std::array<ScreenPoint, 3> corners_;
    DepthPlane plane_;
    int reference_x_, reference_y_;
    Item item_;
    VisibleBand& band_;
    PixelCounts counts_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
