#pragma once

#include <algorithm>

#include "raster/lanes/attributes.h"
#include "raster/lanes/spans.h"
#include "raster/lanes/triangles.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// One small triangle: a lane is a pixel, a vector a piece of a row.
template <class Keep>
class SmallTriangle {
public:
    SmallTriangle(const PreparedTriangles& triangles, int lane,
                  const PreparedAttributes<Keep::attributes>& attributes, const Keep& keep,
                  std::int32_t own, VisibleBand& band)
        : t_(triangles),
          lane_(lane),
          attributes_(attributes),
          keep_(keep),
          own_(own),
          band_(band),
          y_begin_(std::max(t_.y_begin[lane], band.rows().y_begin)),
          y_end_(std::min(t_.y_end[lane], band.rows().y_end)) {}

    PixelCounts draw() const {
        PixelCounts counts;
        for (int x = t_.x_begin[lane_]; x < t_.x_end[lane_]; x += lane_count)
            draw_column(x, counts);
        return counts;
    }

private:
    /// An edge function down a column a vector wide.
    struct EdgeDown {
        Ints value, dy;
        void step() { value += dy; }
    };
    EdgeDown edge(int k, int x) const {
        const int down = y_begin_ - t_.y_begin[lane_];
        const int right = x - t_.x_begin[lane_];
        const std::int32_t first = t_.edge[k][lane_] + down * t_.edge_dy[k][lane_];
        return {Ints(first) + (iota() + Ints(right)) * Ints(t_.edge_dx[k][lane_]),
                Ints(t_.edge_dy[k][lane_])};
    }

    /// A vector wide, from x on.
    void draw_column(int x, PixelCounts& counts) const {
        EdgeDown edges[3] = {edge(0, x), edge(1, x), edge(2, x)};
        const DepthPlane depth = t_.depth_plane(lane_);
        RampLanes z(t_.depth_at(lane_, x, y_begin_), depth.dx, depth.dy);
        PlaneValues<Keep::attributes> values(attributes_, lane_, x, y_begin_);
        values.step_down(attributes_, lane_);
        PixelPlace at = band_.row(y_begin_) + x;
        for (int y = y_begin_; y < y_end_; ++y) {
            const Mask covered = Ints(-1) < (edges[0].value | edges[1].value | edges[2].value);
            const int pixels = count(covered);
            if (pixels > 0) {
                const int passed = store_nearer(covered, z.get(), keep_, Ints(own_), values, at);
                counts += {1, static_cast<std::size_t>(pixels), static_cast<std::size_t>(passed)};
            }
            for (EdgeDown& e : edges)
                e.step();
            z.step();
            values.step();
            at = at + band_.stride();
        }
    }

    const PreparedTriangles& t_;
    int lane_;
    const PreparedAttributes<Keep::attributes>& attributes_;
    const Keep& keep_;
    std::int32_t own_;
    VisibleBand& band_;
    int y_begin_, y_end_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
