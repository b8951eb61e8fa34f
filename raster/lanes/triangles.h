#pragma once

#include "raster/lanes/planes.h"
#include "raster/rows.h"

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

    DepthPlane depth_plane(int lane) const { return {depth[lane], depth_dx[lane], depth_dy[lane]}; }
    /// At the centre of a pixel, as a `Ramp` has it.
    std::int64_t depth_at(int lane, int x, int y) const {
        return depth_plane(lane).at(x - reference_x[lane], y - reference_y[lane]);
    }
};

/// What else of them is known, a lane a triangle, for attributes.
struct TriangleSetup {
    PlaneSetupLanes planes;
    Ints column, row;  // the reference pixel
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
        // A level bottom edge takes its pixels in: only the box leaves them out.
        const Mask in_box = Ints(j) < height;
        const Mask in_band = in_box & (Ints(rows.y_begin - 1) < y) & (y < Ints(rows.y_end));
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

inline void store_depth(const DepthPlaneLanes& plane, const TriangleSetup& setup,
                        PreparedTriangles& out) {
    store(setup.column, out.reference_x);
    store(setup.row, out.reference_y);
    store(plane.origin, out.depth);
    store(plane.dx, out.depth_dx);
    store(plane.dy, out.depth_dy);
}

inline Ints gathered(std::span<const std::int32_t> stream, Ints index) {
    return gather(stream.data(), index);
}

/// `rows` are those of the band.
inline TriangleSetup prepare(const PolygonStreams& streams, const TriangleLanes& v, Rows rows,
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
    const TriangleSetup setup{plane_setup(x, y), shift_right<subpixel_bits>(x[0]),
                              shift_right<subpixel_bits>(y[0])};
    const DepthPlaneLanes plane = depth_plane(setup.planes, z);
    store_depth(plane, setup, out);
    EdgeLanes edges[3];
    edge_functions(x, y, setup.planes.inverse_area > Doubles(0.0), x_begin, y_begin, edges);
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
    return setup;
}

}  // namespace scanlight::raster::HWY_NAMESPACE
