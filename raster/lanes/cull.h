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

/// Culls whole triangles, each inside the view volume or outside one of its planes.
class TriangleCuller {
public:
    TriangleCuller(const PolygonStreams& streams, CullRule rule) : streams_(streams), rule_(rule) {}

    /// Faces [begin, end) in their order. Whoever has not three corners, or is to be clipped, goes
    /// on with `walk_flag`, and its neighbours in the vector too.
    SCANLIGHT_FLATTEN void cull(std::size_t begin, std::size_t end, Survivors& survivors,
                                FateCounts& counts) const {
        survivors.count = 0;
        for (std::size_t f = begin; f < end; f += lane_count) {
            const int n = static_cast<int>(std::min<std::size_t>(lane_count, end - f));
            if (!are_triangles(f, n) || !cull_lanes(f, n, survivors, counts)) {
                pass_on(f, n, survivors);
            }
        }
    }

private:
    bool are_triangles(std::size_t f, int n) const {
        const auto i = static_cast<std::size_t>(n);
        return streams_.face_begin[f + i] - streams_.face_begin[f] == 3 * i;
    }

    static void pass_on(std::size_t f, int n, Survivors& survivors) {
        for (int i = 0; i < n; ++i)
            survivors.pass_on(static_cast<FaceItem>(f + static_cast<std::size_t>(i)));
    }

    /// False, and nothing done, where one of them is to be clipped.
    bool cull_lanes(std::size_t f, int n, Survivors& survivors, FateCounts& counts) const {
        const Mask valid = first_lanes(n);
        const Ints lane = min(iota(), Ints(n - 1));  // no index beyond the last face
        const Ints face = Ints(static_cast<std::int32_t>(f)) + lane;
        const Ints begin(static_cast<std::int32_t>(streams_.face_begin[f]));
        const TriangleLanes v = triangles_from(streams_, begin + lane * Ints(3));
        const Place place = place_of(v);
        const Mask outside = valid & place.outside;
        const Mask inside = valid & place.inside;
        if (any(valid & !(outside | inside))) return false;
        const Ints x[3] = {gather(streams_.x.data(), v.a), gather(streams_.x.data(), v.b),
                           gather(streams_.x.data(), v.c)};
        const Ints y[3] = {gather(streams_.y.data(), v.a), gather(streams_.y.data(), v.b),
                           gather(streams_.y.data(), v.c)};
        const Doubles area = area_lanes(x, y);
        const Mask clockwise = area > Doubles(0.0);
        const Mask back = streams_.mirrored ? !clockwise : clockwise;
        const Mask culled =
            inside & ((rule_.back ? back : none()) | (rule_.front ? !back : none()));
        const Mask drawn = inside & !culled;
        counts.outside += static_cast<std::size_t>(count(outside));
        counts.culled += static_cast<std::size_t>(count(culled));
        counts.drawn += static_cast<std::size_t>(count(drawn));
        keep(drawn & has_area(area), back, face, x, y, survivors);
        return true;
    }

    static Mask none() { return first_lanes(0); }
    static Mask has_area(Doubles area) { return abs(area) > Doubles(0.0); }

    struct Place {
        Mask outside;  // all of it beyond one plane
        Mask inside;   // nothing of it beyond any
    };
    Place place_of(const TriangleLanes& v) const {
        if (streams_.outside_of_any == 0) return {none(), first_lanes(lane_count)};
        const Ints a = outside_of(v.a);
        const Ints b = outside_of(v.b);
        const Ints c = outside_of(v.c);
        return {(a & b & c) != Ints(0), (a | b | c) == Ints(0)};
    }
    Ints outside_of(Ints vertex) const { return gather(streams_.outside.data(), vertex); }

    static void keep(Mask seen, Mask back, Ints face, const Ints (&x)[3], const Ints (&y)[3],
                     Survivors& survivors) {
        const Range xs = range_of(x[0], x[1], x[2]);
        const Range ys = range_of(y[0], y[1], y[2]);
        const Ints y_begin = first_centre_lanes(ys.low);
        const Ints y_end = first_centre_lanes(ys.high);
        const Mask kept =
            seen & (y_begin < y_end) & (first_centre_lanes(xs.low) < first_centre_lanes(xs.high));
        if (!any(kept)) return;
        const Ints item = face | select(back, Ints(static_cast<std::int32_t>(back_flag)), Ints(0));
        compress(kept, item, survivors.item.data() + survivors.count);
        compress(kept, y_begin, survivors.y_begin.data() + survivors.count);
        compress(kept, y_end, survivors.y_end.data() + survivors.count);
        survivors.count += static_cast<std::size_t>(count(kept));
    }

    const PolygonStreams& streams_;
    CullRule rule_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
