#pragma once

#include "raster/lanes/numbers.h"
#include "raster/polygon_streams.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// The first row (or column) whose centre is at or after each coordinate.
inline Ints first_centre_lanes(Ints coordinate) {
    return shift_right<subpixel_bits>(coordinate + Ints(half_pixel - 1));
}

/// As many triangles as there are lanes: the vertices of their corners.
struct TriangleLanes {
    Ints a, b, c;
};

/// From the first of their corners on.
inline TriangleLanes triangles_from(const PolygonStreams& streams, Ints begin) {
    const auto* corners = reinterpret_cast<const std::int32_t*>(streams.corners.data());
    return {gather(corners, begin), gather(corners, begin + Ints(1)),
            gather(corners, begin + Ints(2))};
}

inline TriangleLanes triangles_at(const PolygonStreams& streams, Ints face) {
    if (streams.are_triangles()) return triangles_from(streams, face * Ints(3));
    const auto* begins = reinterpret_cast<const std::int32_t*>(streams.face_begin.data());
    return triangles_from(streams, gather(begins, face));
}

/// Smallest and largest of three.
struct Range {
    Ints low, high;
};
inline Range range_of(Ints a, Ints b, Ints c) {
    return {min(a, min(b, c)), max(a, max(b, c))};
}

/// Twice the signed area, exact; positive for triangles that run clockwise on the screen, whose y
/// grows downward.
inline Doubles area_lanes(const Ints (&x)[3], const Ints (&y)[3]) {
    const Doubles x1 = doubles_of(x[1] - x[0]);
    const Doubles y1 = doubles_of(y[1] - y[0]);
    const Doubles x2 = doubles_of(x[2] - x[0]);
    const Doubles y2 = doubles_of(y[2] - y[0]);
    return x1 * y2 - x2 * y1;
}

inline void compress(Mask kept, Ints values, std::int32_t* to) {
    hn::CompressStore(values.v, int_mask(kept), IntTag(), to);
}

/// Culls triangles and quads, each inside the view volume or outside one of its planes.
class FaceCuller {
public:
    FaceCuller(const PolygonStreams& streams, CullRule rule) : streams_(streams), rule_(rule) {}

    /// Faces [begin, end) in their order. A vector is passed on where its polygons have not all
    /// three, or all four, corners; and where one of them is to be clipped.
    SCANLIGHT_FLATTEN void cull(std::size_t begin, std::size_t end, Survivors& survivors,
                                FateCounts& counts) const {
        survivors.count = 0;
        for (std::size_t f = begin; f < end; f += lane_count) {
            const int n = static_cast<int>(std::min<std::size_t>(lane_count, end - f));
            const bool done = are_all<3>(f, n)   ? cull_lanes<3>(f, n, survivors, counts)
                              : are_all<4>(f, n) ? cull_lanes<4>(f, n, survivors, counts)
                                                 : false;
            if (!done) pass_on(f, n, survivors);
        }
    }

private:
    /// Faces [f, f + n) have so many corners each.
    template <int corners>
    bool are_all(std::size_t f, int n) const {
        const std::uint32_t* begins = streams_.face_begin.data() + f;
        if (begins[n] - begins[0] != static_cast<std::uint32_t>(corners * n)) return false;
        if constexpr (corners == 3) return true;  // none has fewer
        std::uint32_t others = 0;
        for (int i = 0; i < n; ++i)
            others |= begins[i + 1] - begins[i] - corners;
        return others == 0;
    }

    static void pass_on(std::size_t f, int n, Survivors& survivors) {
        for (int i = 0; i < n; ++i)
            survivors.pass_on(static_cast<FaceItem>(f + static_cast<std::size_t>(i)));
    }

    /// As many polygons as there are lanes.
    template <int corners>
    struct Polygons {
        Ints vertex[corners];
        Ints x[corners], y[corners];
    };

    /// False, and nothing done, where one of them is to be clipped.
    template <int corners>
    bool cull_lanes(std::size_t f, int n, Survivors& survivors, FateCounts& counts) const {
        const Mask valid = first_lanes(n);
        const Ints lane = min(iota(), Ints(n - 1));  // no index beyond the last face
        const Ints begin =
            Ints(static_cast<std::int32_t>(streams_.face_begin[f])) + lane * Ints(corners);
        Polygons<corners> p;
        gather_corners(begin, p);
        const Place place = place_of(p);
        const Mask outside = valid & place.outside;
        const Mask inside = valid & place.inside;
        if (any(valid & !(outside | inside))) return false;
        gather_positions(p);
        const Doubles area = area_of(p);
        const Mask clockwise = area > Doubles(0.0);
        const Mask back = streams_.mirrored ? !clockwise : clockwise;
        const Mask culled =
            inside & ((rule_.back ? back : none()) | (rule_.front ? !back : none()));
        const Mask drawn = inside & !culled;
        counts.outside += static_cast<std::size_t>(count(outside));
        counts.culled += static_cast<std::size_t>(count(culled));
        counts.drawn += static_cast<std::size_t>(count(drawn));
        const Ints face = Ints(static_cast<std::int32_t>(f)) + lane;
        keep(corners == 3 ? drawn & has_area(area) : drawn, back, face, p, survivors);
        return true;
    }

    static Mask none() { return first_lanes(0); }
    static Mask has_area(Doubles area) { return abs(area) > Doubles(0.0); }

    template <int corners>
    void gather_corners(Ints begin, Polygons<corners>& p) const {
        const auto* vertices = reinterpret_cast<const std::int32_t*>(streams_.corners.data());
        for (int i = 0; i < corners; ++i)
            p.vertex[i] = gather(vertices, begin + Ints(i));
    }
    template <int corners>
    void gather_positions(Polygons<corners>& p) const {
        for (int i = 0; i < corners; ++i) {
            p.x[i] = gather(streams_.x.data(), p.vertex[i]);
            p.y[i] = gather(streams_.y.data(), p.vertex[i]);
        }
    }

    struct Place {
        Mask outside;  // all of it beyond one plane
        Mask inside;   // nothing of it beyond any
    };
    template <int corners>
    Place place_of(const Polygons<corners>& p) const {
        if (streams_.outside_of_any == 0) return {none(), first_lanes(lane_count)};
        Ints of_one_plane(~0);
        Ints of_any(0);
        for (const Ints vertex : p.vertex) {
            const Ints outside = gather(streams_.outside.data(), vertex);
            of_one_plane = of_one_plane & outside;
            of_any = of_any | outside;
        }
        return {of_one_plane != Ints(0), of_any == Ints(0)};
    }

    static Doubles area_of(const Polygons<3>& p) { return area_lanes(p.x, p.y); }
    /// Of its diagonals, by the same rule.
    static Doubles area_of(const Polygons<4>& p) {
        return doubles_of(p.x[2] - p.x[0]) * doubles_of(p.y[3] - p.y[1]) -
               doubles_of(p.x[3] - p.x[1]) * doubles_of(p.y[2] - p.y[0]);
    }

    template <int corners>
    static Range range_of(const Ints (&values)[corners]) {
        Range range{values[0], values[0]};
        for (int i = 1; i < corners; ++i) {
            range.low = min(range.low, values[i]);
            range.high = max(range.high, values[i]);
        }
        return range;
    }

    template <int corners>
    static void keep(Mask seen, Mask back, Ints face, const Polygons<corners>& p,
                     Survivors& survivors) {
        constexpr FaceItem walked = corners == 3 ? 0 : walk_flag;
        const Range xs = range_of(p.x);
        const Range ys = range_of(p.y);
        const Ints y_begin = first_centre_lanes(ys.low);
        const Ints y_end = first_centre_lanes(ys.high);
        const Mask kept =
            seen & (y_begin < y_end) & (first_centre_lanes(xs.low) < first_centre_lanes(xs.high));
        if (!any(kept)) return;
        const Ints flags = select(back, Ints(static_cast<std::int32_t>(back_flag)), Ints(0)) |
                           Ints(static_cast<std::int32_t>(walked));
        compress(kept, face | flags, survivors.item.data() + survivors.count);
        compress(kept, y_begin, survivors.y_begin.data() + survivors.count);
        compress(kept, y_end, survivors.y_end.data() + survivors.count);
        survivors.count += static_cast<std::size_t>(count(kept));
    }

    const PolygonStreams& streams_;
    CullRule rule_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
