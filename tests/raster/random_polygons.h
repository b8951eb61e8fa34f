#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <vector>

#include "raster/crossing.h"
#include "raster/vertex.h"
#include "tests/raster/cases.h"

namespace scanlight::raster {

inline std::ostream& operator<<(std::ostream& out, const ScreenPoint& p) {
    return out << '(' << p.x << ',' << p.y << ')';
}

inline bool operator==(const ScreenPoint& a, const ScreenPoint& b) {
    return a.x == b.x && a.y == b.y;
}

}  // namespace scanlight::raster

namespace scanlight::raster::laws {

/// The corners of a polygon, in 1/256 pixel. All generators keep them within [0, extent] both ways
/// and give simple polygons: no two edges cross.
using Points = std::vector<ScreenPoint>;

/// Twice the area of the triangle abc, positive when c lies to the right of the way from a to b as
/// seen on the screen.
inline std::int64_t cross(ScreenPoint a, ScreenPoint b, ScreenPoint c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// One coordinate in four lies on a pixel's centre or border, where the ties are.
inline SubPixel random_coordinate(Random& random, int extent) {
    const int c = random.between(0, extent);
    return random.one_in(4) ? c / half_pixel * half_pixel : c;
}

inline ScreenPoint random_point(Random& random, int extent) {
    const SubPixel x = random_coordinate(random, extent);
    return {x, random_coordinate(random, extent)};
}

inline Points random_triangle(Random& random, int extent) {
    const ScreenPoint a = random_point(random, extent);
    const ScreenPoint b = random_point(random, extent);
    return {a, b, random_point(random, extent)};
}

/// A triangle a few 1/256 pixel wide.
inline Points random_sliver(Random& random, int extent) {
    const ScreenPoint a = random_point(random, extent);
    const ScreenPoint b = random_point(random, extent);
    const int part = random.between(0, 256);
    const auto between = [&](SubPixel from, SubPixel to) {
        const auto along = from + std::int64_t{to - from} * part / 256 + random.between(-2, 2);
        return static_cast<SubPixel>(std::clamp<std::int64_t>(along, 0, extent));
    };
    const SubPixel x = between(a.x, b.x);
    return {a, b, {x, between(a.y, b.y)}};
}

/// Smaller than a pixel.
inline Points random_speck(Random& random, int extent) {
    const ScreenPoint corner = random_point(random, extent - subpixels);
    Points speck = random_triangle(random, subpixels);
    for (auto& p : speck)
        p = {corner.x + p.x, corner.y + p.y};
    return speck;
}

/// The hull of random points (Andrew 1979), without corners on straight edges.
inline Points random_convex(Random& random, int extent) {
    Points cloud;
    for (int i = random.between(3, 9); i > 0; --i)
        cloud.push_back(random_point(random, extent));
    std::sort(cloud.begin(), cloud.end(),
              [](ScreenPoint a, ScreenPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Points hull;
    const auto add = [&hull](ScreenPoint p, std::size_t floor) {
        while (hull.size() >= floor + 2 && cross(hull.end()[-2], hull.end()[-1], p) <= 0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const auto p : cloud)
        add(p, 0);
    const std::size_t floor = hull.size() - 1;
    for (auto p = cloud.rbegin(); p != cloud.rend(); ++p)
        add(*p, floor);
    hull.pop_back();
    return hull;
}

/// Whether each corner follows the one before it by less than half a turn about `centre`.
inline bool winds_about(const Points& polygon, ScreenPoint centre) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (cross(centre, polygon[i], polygon[(i + 1) % polygon.size()]) <= 0) return false;
    }
    return polygon.size() >= 3;
}

/// A concave polygon, all of whose boundary is seen from the middle of the square.
inline Points random_star(Random& random, int extent) {
    const ScreenPoint centre{extent / 2, extent / 2};
    const auto upper = [centre](ScreenPoint p) {
        return p.y < centre.y || (p.y == centre.y && p.x < centre.x);
    };
    for (;;) {
        Points star;
        for (int i = random.between(4, 10); i > 0; --i)
            star.push_back(random_point(random, extent));
        std::sort(star.begin(), star.end(), [&](ScreenPoint a, ScreenPoint b) {
            return upper(a) != upper(b) ? upper(a) : cross(centre, a, b) > 0;
        });
        if (winds_about(star, centre)) return star;
    }
}

inline ScreenPoint transposed(ScreenPoint p) {
    return {p.y, p.x};
}

/// Teeth above and below: many edges on a scanline, or (transposed) many local tops and bottoms.
inline Points random_comb(Random& random, int extent) {
    const int teeth = random.between(2, 6);
    const int pitch = extent / teeth;
    Points above;
    Points below;
    for (int i = 0; i < teeth; ++i) {
        const SubPixel x = i * pitch + random.between(0, pitch - 1);
        above.push_back({x, random_coordinate(random, extent / 2 - 1)});
        below.push_back({x, extent / 2 + random_coordinate(random, extent / 2)});
    }
    Points comb = above;
    comb.insert(comb.end(), below.rbegin(), below.rend());
    if (random.one_in(2)) std::transform(comb.begin(), comb.end(), comb.begin(), transposed);
    return comb;
}

/// A vector v with u.x v.y - u.y v.x = 1, no longer than u, whose parts have no common divisor
/// (Euclid's algorithm, run backwards).
inline ScreenPoint partner(ScreenPoint u) {
    if (u.y == 0) return {0, u.x};
    const ScreenPoint v = partner({u.y, u.x % u.y});
    return {-v.y - u.x / u.y * v.x, -v.x};
}

/// The thinnest triangle there is about a point, which is its centroid: twice its area is 3/65536
/// of a pixel, its length up to a quarter of the largest picture.
inline Points random_needle(Random& random, ScreenPoint p) {
    constexpr int longest = max_size * subpixels / 8;
    ScreenPoint u{random.between(1, longest), random.between(1, longest)};
    const int divisor = std::gcd(u.x, u.y);
    u = {u.x / divisor, u.y / divisor};
    const ScreenPoint v = partner(u);
    return {{p.x + u.x, p.y + u.y}, {p.x + v.x, p.y + v.y}, {p.x - u.x - v.x, p.y - u.y - v.y}};
}

inline Points random_polygon(Random& random, int extent) {
    switch (random.between(0, 5)) {
        case 0:
            return random_sliver(random, extent);
        case 1:
            return random_speck(random, extent);
        case 2:
            return random_convex(random, extent);
        case 3:
            return random_star(random, extent);
        case 4:
            return random_comb(random, extent);
        default:
            return random_triangle(random, extent);
    }
}

template <int N>
std::vector<ScreenVertex<N>> without_values(const Points& points) {
    std::vector<ScreenVertex<N>> polygon;
    for (const auto& p : points)
        polygon.push_back({p.x, p.y, 0, {}});
    return polygon;
}

/// Depths and attributes anywhere in the range that corners have.
template <int N>
std::vector<ScreenVertex<N>> with_random_values(const Points& points, Random& random) {
    const Attribute limit = attribute_from_float(attribute_limit);
    auto polygon = without_values<N>(points);
    for (auto& corner : polygon) {
        corner.z = random.between(0, depth_far);
        for (auto& attribute : corner.attributes)
            attribute = random.between(-limit, limit);
    }
    return polygon;
}

}  // namespace scanlight::raster::laws
