#pragma once

#include <algorithm>

#include "raster/lanes/planes.h"
#include "raster/lanes/spans.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// Triangles whose boxes have at most this many rows and columns are covered by edge functions, in
/// 32 bits; larger ones by the walk down their edges.
inline constexpr int small_size = 64;

/// What drawing needs to know of as many triangles as there are lanes, lane by lane.
struct alignas(64) PreparedTriangles {
    using Lane32 = std::int32_t[lane_count];
    using Lane64 = std::int64_t[lane_count];

    Lane32 x_begin, x_end, y_begin, y_end;  // box in pixels, half-open
    // The edge function of each edge: at the centre of the box's first pixel, and its steps. At or
    // above 0 lies what the triangle covers.
    Lane32 edge[3], edge_dx[3], edge_dy[3];
    Lane32 reference_x, reference_y;
    Lane64 depth, depth_dx, depth_dy;
    std::uint32_t planar;  // a bit a lane: which have a plane
    std::uint32_t small;   // which are small
};

/// Pineda 1988, "A Parallel Algorithm for Polygon Rasterization": E(p) of the edge from a to b,
/// positive on the inner side. The edge belongs to the triangle when it is a left or a top one:
/// others lose their zero.
struct EdgeLanes {
    Ints value, dx, dy;
};

inline EdgeLanes edge_function(Ints ax, Ints ay, Ints bx, Ints by, Ints at_x, Ints at_y) {
    const Ints along_x = bx - ax;
    const Ints along_y = by - ay;
    const Ints bias = select(along_y > Ints(0), Ints(-1), Ints(0));
    return {along_x * (at_y - ay) - along_y * (at_x - ax) + bias,
            shift_left<subpixel_bits>(Ints(0) - along_y), shift_left<subpixel_bits>(along_x)};
}

/// The centre of a row or column, in sub-pixels.
inline Ints centre_lanes(Ints index) {
    return shift_left<subpixel_bits>(index) + Ints(half_pixel);
}

inline void prepare_edges(const Ints (&x)[3], const Ints (&y)[3], Mask clockwise, Ints x_begin,
                          Ints y_begin, PreparedTriangles& out) {
    // Clockwise on the screen, the inside lies at the positive side of all three edges.
    const Ints cx[3] = {x[0], select(clockwise, x[1], x[2]), select(clockwise, x[2], x[1])};
    const Ints cy[3] = {y[0], select(clockwise, y[1], y[2]), select(clockwise, y[2], y[1])};
    for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        const EdgeLanes e = edge_function(cx[k], cy[k], cx[next], cy[next], centre_lanes(x_begin),
                                          centre_lanes(y_begin));
        store(e.value, out.edge[k]);
        store(e.dx, out.edge_dx[k]);
        store(e.dy, out.edge_dy[k]);
    }
}

inline void prepare_depth(const DepthPlaneLanes& plane, Ints x0, Ints y0, PreparedTriangles& out) {
    store(shift_right<subpixel_bits>(x0), out.reference_x);
    store(shift_right<subpixel_bits>(y0), out.reference_y);
    store(plane.origin, out.depth);
    store(plane.dx, out.depth_dx);
    store(plane.dy, out.depth_dy);
}

inline Ints gathered(std::span<const std::int32_t> stream, Ints index) {
    return gather(stream.data(), index);
}

inline void prepare(const PolygonStreams& streams, const TriangleLanes& v, PreparedTriangles& out) {
    const Ints x[3] = {gathered(streams.x, v.a), gathered(streams.x, v.b),
                       gathered(streams.x, v.c)};
    const Ints y[3] = {gathered(streams.y, v.a), gathered(streams.y, v.b),
                       gathered(streams.y, v.c)};
    const Ints z[3] = {gathered(streams.z, v.a), gathered(streams.z, v.b),
                       gathered(streams.z, v.c)};
    const Range xs = range_of(x[0], x[1], x[2]);
    const Range ys = range_of(y[0], y[1], y[2]);
    const Ints x_begin = first_centre_lanes(xs.low);
    const Ints x_end = first_centre_lanes(xs.high);
    const Ints y_begin = first_centre_lanes(ys.low);
    const Ints y_end = first_centre_lanes(ys.high);
    store(x_begin, out.x_begin);
    store(x_end, out.x_end);
    store(y_begin, out.y_begin);
    store(y_end, out.y_end);
    const PlaneSetupLanes setup = plane_setup(x, y);
    const DepthPlaneLanes plane = depth_plane(setup, z);
    prepare_depth(plane, x[0], y[0], out);
    prepare_edges(x, y, setup.inverse_area > Doubles(0.0), x_begin, y_begin, out);
    const Ints limit(small_size * subpixels);
    out.planar = bits_of(plane.exists);
    out.small = bits_of((xs.high - xs.low < limit) & (ys.high - ys.low < limit));
}

/// One small triangle: a lane is a pixel, a vector a piece of a row.
class SmallTriangle {
public:
    SmallTriangle(const PreparedTriangles& t, int lane, Item item, VisibleBand& band)
        : item_(item), band_(band), x_begin_(t.x_begin[lane]), x_end_(t.x_end[lane]) {
        y_begin_ = std::max(t.y_begin[lane], band.rows().y_begin);
        y_end_ = std::min(t.y_end[lane], band.rows().y_end);
        const int skipped = y_begin_ - t.y_begin[lane];
        for (int k = 0; k < 3; ++k) {
            edge_[k] = t.edge[k][lane] + skipped * t.edge_dy[k][lane];
            edge_dx_[k] = t.edge_dx[k][lane];
            edge_dy_[k] = t.edge_dy[k][lane];
        }
        const DepthPlane plane{t.depth[lane], t.depth_dx[lane], t.depth_dy[lane]};
        depth_ = plane.at(x_begin_ - t.reference_x[lane], y_begin_ - t.reference_y[lane]);
        depth_dx_ = plane.dx;
        depth_dy_ = plane.dy;
    }

    PixelCounts draw() const {
        PixelCounts counts;
        for (int x = x_begin_; x < x_end_; x += lane_count)
            draw_column(x, counts);
        return counts;
    }

private:
    /// A vector wide, from x on.
    void draw_column(int x, PixelCounts& counts) const {
        const int right = x - x_begin_;
        const Ints column = iota() + Ints(right);
        Ints edge0 = Ints(edge_[0]) + column * Ints(edge_dx_[0]);
        Ints edge1 = Ints(edge_[1]) + column * Ints(edge_dx_[1]);
        Ints edge2 = Ints(edge_[2]) + column * Ints(edge_dx_[2]);
        RampLanes z(depth_ + right * depth_dx_, depth_dx_, depth_dy_);
        Depth* depth = band_.depth_row(y_begin_) + x;
        Item* items = band_.item_row(y_begin_) + x;
        for (int y = y_begin_; y < y_end_; ++y) {
            const Mask covered = Ints(-1) < (edge0 | edge1 | edge2);
            const int pixels = count(covered);
            if (pixels > 0) {
                ++counts.spans;
                counts.tested += static_cast<std::size_t>(pixels);
                counts.passed += static_cast<std::size_t>(
                    store_nearer(covered, z.get(), Ints(item_), depth, items));
            }
            edge0 += Ints(edge_dy_[0]);
            edge1 += Ints(edge_dy_[1]);
            edge2 += Ints(edge_dy_[2]);
            z.step();
            depth += band_.stride();
            items += band_.stride();
        }
    }

    Item item_;
    VisibleBand& band_;
    int x_begin_, x_end_, y_begin_, y_end_;
    std::int32_t edge_[3], edge_dx_[3], edge_dy_[3];
    std::int64_t depth_, depth_dx_, depth_dy_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
