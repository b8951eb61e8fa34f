#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/bins.h"
#include "raster/project.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster::laws {

/// Random polygons as the vertex stage hands them on: inside the view volume, beyond one of its
/// planes, or to be clipped. Of vertices outside the coordinates are rubbish, as there.
class RandomStreams {
public:
    /// Within [0, extent] sub-pixels both ways.
    RandomStreams(Random& random, int faces, int extent) : random_(random), extent_(extent) {
        for (int i = 0; i < faces; ++i)
            add_face();
        mirrored_ = random.one_in(2);
    }

    PolygonStreams streams() const {
        return {x_, y_, z_, outside_, corners_, face_begin_, mirrored_};
    }
    std::size_t face_count() const { return clipped_.size(); }

    /// What is left of a face to be clipped: as good as any other polygon.
    const std::vector<ScreenVertex<0>>& clipped(std::size_t face) const { return clipped_[face]; }

private:
    enum class Place { inside, beyond_a_plane, across };

    void add_face() {
        const auto place = random_.one_in(12)  ? Place::across
                           : random_.one_in(6) ? Place::beyond_a_plane
                                               : Place::inside;
        // Triangles and quads in long runs, or there would hardly be a vector of them.
        if (random_.one_in(20)) quads_ = !quads_;
        const auto points = random_.one_in(25) ? random_polygon(random_, extent_)
                            : quads_           ? any_quad()
                                               : any_triangle();
        const std::int32_t plane = 1 << random_.between(0, 5);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::int32_t others = random_.between(0, 63);
            if (place == Place::inside) add_vertex(points[i], 0);
            if (place == Place::beyond_a_plane) add_vertex(rubbish(), plane | others);
            if (place == Place::across && i == 0) add_vertex(points[i], 0);
            if (place == Place::across && i > 0) add_vertex(rubbish(), plane);
        }
        face_begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
        const bool left_over = place == Place::across && !random_.one_in(4);
        clipped_.push_back(left_over ? without_values<0>(random_polygon(random_, extent_))
                                     : std::vector<ScreenVertex<0>>{});
    }

    Points any_triangle() {
        if (random_.one_in(4)) return random_speck(random_, extent_);
        if (random_.one_in(8)) return random_sliver(random_, extent_);
        return random_triangle(random_, extent_);
    }

    /// Its edges may cross.
    Points any_quad() {
        Points quad = any_triangle();
        quad.push_back(random_point(random_, extent_));
        return quad;
    }

    ScreenPoint rubbish() {
        const SubPixel x = random_.between(-2'000'000'000, 2'000'000'000);
        return {x, random_.between(-2'000'000'000, 2'000'000'000)};
    }

    void add_vertex(ScreenPoint p, std::int32_t outside) {
        corners_.push_back(static_cast<std::uint32_t>(x_.size()));
        x_.push_back(p.x);
        y_.push_back(p.y);
        z_.push_back(random_.between(0, depth_far));
        outside_.push_back(outside);
    }

    Random& random_;
    int extent_;
    std::vector<std::int32_t> x_, y_, z_, outside_;
    std::vector<std::uint32_t> corners_, face_begin_{0};
    std::vector<std::vector<ScreenVertex<0>>> clipped_;
    bool mirrored_ = false;
    bool quads_ = false;
};

/// What becomes of a face, worked out for it alone.
struct FaceFate {
    enum Kind { outside, culled, drawn } kind = outside;
    bool back = false;
    bool clipped = false;
    bool walked = false;  // clipped, or no triangle
    Rows rows{0, 0};
    bool may_cover = false;  // a pixel's centre lies in its box; a triangle has an area
};

inline bool has_centre(SubPixel begin, SubPixel end) {
    return first_centre(begin) < first_centre(end);
}

inline FaceFate seen_fate(const std::vector<ScreenVertex<0>>& corners, bool mirrored,
                          CullRule rule) {
    FaceFate fate;
    const std::int64_t area = signed_area(corners);
    const bool counter_clockwise = area >= 0;
    fate.back = counter_clockwise == mirrored;
    fate.kind = (fate.back ? rule.back : rule.front) ? FaceFate::culled : FaceFate::drawn;
    const auto [left, right] = std::ranges::minmax(corners, {}, &ScreenVertex<0>::x);
    const auto [top, bottom] = std::ranges::minmax(corners, {}, &ScreenVertex<0>::y);
    fate.rows = {first_centre(top.y), first_centre(bottom.y)};
    fate.may_cover = (area != 0 || corners.size() != 3) && has_centre(left.x, right.x) &&
                     has_centre(top.y, bottom.y);
    return fate;
}

inline FaceFate fate_of(const RandomStreams& random, std::size_t face, CullRule rule) {
    const PolygonStreams streams = random.streams();
    std::int32_t any = 0;
    std::int32_t all = ~0;
    std::vector<ScreenVertex<0>> corners;
    for (const std::uint32_t v : streams.face(face)) {
        any |= streams.outside[v];
        all &= streams.outside[v];
        corners.push_back(streams.corner(v));
    }
    if (all != 0) return {};
    if (any != 0) corners = random.clipped(face);
    if (corners.size() < 3) return {};
    FaceFate fate = seen_fate(corners, streams.mirrored, rule);
    fate.clipped = any != 0;
    fate.walked = fate.clipped || corners.size() != 3;
    return fate;
}

inline void count_fate(FateCounts& counts, const FaceFate& fate) {
    if (fate.kind == FaceFate::outside) ++counts.outside;
    if (fate.kind == FaceFate::culled) ++counts.culled;
    if (fate.kind == FaceFate::drawn) ++counts.drawn;
}

inline CullRule random_rule(Random& random) {
    const int which = random.between(0, 2);
    return {.front = which == 1, .back = which == 2};
}

}  // namespace scanlight::raster::laws
