#pragma once

#include <algorithm>

#include "raster/lanes/one_triangle.h"
#include "raster/lanes/spans.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// One small triangle: a lane is a pixel, a vector a piece of a row.
template <class Keep>
class SmallTriangle {
public:
    explicit SmallTriangle(const OneTriangle<Keep>& triangle)
        : t_(triangle),
          y_begin_(std::max(t_.y_begin(), t_.band.rows().y_begin)),
          y_end_(std::min(t_.y_end(), t_.band.rows().y_end)) {}

    PixelCounts draw() const {
        PixelCounts counts;
        for (int x = first_column(); x < t_.x_end(); x += lane_count)
            draw_column(x, counts);
        return counts;
    }

private:
    /// With a line of the cache, if that takes no vector more: each is a whole column here.
    int first_column() const {
        const int line = t_.x_begin() & -lane_count;
        const auto vectors = [&](int x) { return (t_.x_end() - x + lane_count - 1) / lane_count; };
        return vectors(line) > vectors(t_.x_begin()) ? t_.x_begin() : line;
    }

    /// An edge function down a column a vector wide.
    struct EdgeDown {
        Ints value, dy;
        void step() { value += dy; }
    };
    EdgeDown edge(int k, int x) const {
        const int down = y_begin_ - t_.y_begin();
        const int right = x - t_.x_begin();
        const std::int32_t first = t_.t.edge[k][t_.lane] + down * t_.t.edge_dy[k][t_.lane];
        return {Ints(first) + (iota() + Ints(right)) * Ints(t_.t.edge_dx[k][t_.lane]),
                Ints(t_.t.edge_dy[k][t_.lane])};
    }

    /// A vector wide, from x on.
    void draw_column(int x, PixelCounts& counts) const {
        EdgeDown edges[3] = {edge(0, x), edge(1, x), edge(2, x)};
        const DepthPlane depth = t_.depth_plane();
        RampLanes z(t_.depth_at(x, y_begin_), depth.dx, depth.dy);
        typename OneTriangle<Keep>::Values values(t_.attributes, t_.lane, x, y_begin_);
        values.step_down(t_.attributes, t_.lane);
        PixelPlace at = t_.band.row(y_begin_) + x;
        for (int y = y_begin_; y < y_end_; ++y) {
            const Mask covered = Ints(-1) < (edges[0].value | edges[1].value | edges[2].value);
            const int pixels = count(covered);
            if (pixels > 0) {
                const int passed =
                    store_nearer(covered, z.get(), t_.keep, Ints(t_.own), values, at);
                counts += {1, static_cast<std::size_t>(pixels), static_cast<std::size_t>(passed)};
            }
            for (EdgeDown& e : edges)
                e.step();
            z.step();
            values.step();
            at = at + t_.band.stride();
        }
    }

    const OneTriangle<Keep> t_;
    int y_begin_, y_end_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
