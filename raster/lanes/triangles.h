#pragma once

#include <algorithm>

#include "raster/lanes/planes.h"
#include "raster/lanes/spans.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// Triangles whose boxes have at most this many rows and columns are covered by edge functions, in
/// 32 bits; larger ones by the walk down their edges.
inline constexpr int small_size = 64;

/// Triangles whose boxes have at most this many columns and rows, one bit each in 32, are covered
/// with many others at once and drawn pixel by pixel.
inline constexpr int tiny_columns = 4;
inline constexpr int tiny_rows = 8;

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
    Lane32 pixels;  // of tiny ones, those in the band: bit 4 row + column of the box
    // A bit a lane:
    std::uint32_t planar;  // which have a plane
    std::uint32_t small;   // which are small
    std::uint32_t tiny;    // which are tiny
    std::uint32_t unseen;  // which are tiny and cover no pixel
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

/// The edges of small triangles, at the centre of the first pixel of their boxes.
inline void edge_functions(const Ints (&x)[3], const Ints (&y)[3], Mask clockwise, Ints x_begin,
                           Ints y_begin, EdgeLanes (&edges)[3]) {
    // Clockwise on the screen, the inside lies at the positive side of all three edges.
    const Ints cx[3] = {x[0], select(clockwise, x[1], x[2]), select(clockwise, x[2], x[1])};
    const Ints cy[3] = {y[0], select(clockwise, y[1], y[2]), select(clockwise, y[2], y[1])};
    for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        edges[k] = edge_function(cx[k], cy[k], cx[next], cy[next], centre_lanes(x_begin),
                                 centre_lanes(y_begin));
    }
}

inline void store_edges(const EdgeLanes (&edges)[3], PreparedTriangles& out) {
    for (int k = 0; k < 3; ++k) {
        store(edges[k].value, out.edge[k]);
        store(edges[k].dx, out.edge_dx[k]);
        store(edges[k].dy, out.edge_dy[k]);
    }
}

/// Which pixels of their boxes tiny triangles cover, of those in the band's rows. A lane is a
/// triangle.
inline Ints tiny_coverage(EdgeLanes (&edges)[3], Ints y_begin, Ints y_end, Mask tiny, Rows rows) {
    const Ints height = select(tiny, y_end - y_begin, Ints(0));
    Ints pixels(0);
    for (int j = 0; any(Ints(j) < height); ++j) {
        const Ints y = y_begin + Ints(j);
        const Mask in_band = tiny & (Ints(rows.y_begin - 1) < y) & (y < Ints(rows.y_end));
        Ints e[3] = {edges[0].value, edges[1].value, edges[2].value};
        for (int i = 0; i < tiny_columns; ++i) {
            const Mask covered = in_band & (Ints(-1) < (e[0] | e[1] | e[2]));
            const auto bit = static_cast<std::int32_t>(1u << (tiny_columns * j + i));
            pixels = pixels | select(covered, Ints(bit), Ints(0));
            for (int k = 0; k < 3; ++k)
                e[k] += edges[k].dx;
        }
        for (EdgeLanes& edge : edges)
            edge.value += edge.dy;
    }
    return pixels;
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

/// `rows` are those of the band.
inline void prepare(const PolygonStreams& streams, const TriangleLanes& v, Rows rows,
                    PreparedTriangles& out) {
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
    EdgeLanes edges[3];
    edge_functions(x, y, setup.inverse_area > Doubles(0.0), x_begin, y_begin, edges);
    store_edges(edges, out);
    const Ints limit(small_size * subpixels);
    const Mask small = (xs.high - xs.low < limit) & (ys.high - ys.low < limit);
    const Mask tiny = plane.exists & (x_end - x_begin < Ints(tiny_columns + 1)) &
                      (y_end - y_begin < Ints(tiny_rows + 1));
    const Ints pixels = tiny_coverage(edges, y_begin, y_end, tiny, rows);
    store(pixels, out.pixels);
    out.planar = bits_of(plane.exists);
    out.small = bits_of(small);
    out.tiny = bits_of(tiny);
    out.unseen = bits_of(tiny & (pixels == Ints(0)));
}

/// How many rows of a tiny box hold pixels.
inline std::size_t tiny_row_count(std::uint32_t pixels) {
    const std::uint32_t pairs = pixels | pixels >> 1;
    return static_cast<std::size_t>(std::popcount((pairs | pairs >> 2) & 0x11111111u));
}

/// Draws the pixels of one tiny triangle one by one.
inline PixelCounts draw_tiny(const PreparedTriangles& t, int lane, Item item, VisibleBand& band) {
    const DepthPlane plane{t.depth[lane], t.depth_dx[lane], t.depth_dy[lane]};
    const std::int64_t z =
        plane.at(t.x_begin[lane] - t.reference_x[lane], t.y_begin[lane] - t.reference_y[lane]);
    Depth* const depth = band.depth_row(band.rows().y_begin) + t.x_begin[lane];
    Item* const items = band.item_row(band.rows().y_begin) + t.x_begin[lane];
    const int first_row = t.y_begin[lane] - band.rows().y_begin;  // above the band: negative
    const auto stride = static_cast<int>(band.stride());
    const auto pixels = static_cast<std::uint32_t>(t.pixels[lane]);
    std::size_t passed = 0;
    for (std::uint32_t left = pixels; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const int column = bit % tiny_columns;
        const int row = bit / tiny_columns;
        const Depth d = Ramp{z + column * plane.dx + row * plane.dy, 0}.get();
        const int at = (first_row + row) * stride + column;
        if (d >= depth[at]) continue;
        depth[at] = d;
        items[at] = item;
        ++passed;
    }
    return {tiny_row_count(pixels), static_cast<std::size_t>(std::popcount(pixels)), passed};
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
