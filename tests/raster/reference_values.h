#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "raster/span.h"
#include "tests/raster/random_polygons.h"
#include "tests/raster/reference_coverage.h"

namespace scanlight::raster::laws {

/// The numbers of a polygon's corners: one attribute, or the depth.
template <int N>
std::vector<std::int64_t> corner_depths(const std::vector<ScreenVertex<N>>& polygon) {
    std::vector<std::int64_t> values;
    for (const auto& corner : polygon)
        values.push_back(corner.z);
    return values;
}

template <int N>
std::vector<std::int64_t> corner_attributes(const std::vector<ScreenVertex<N>>& polygon,
                                            std::size_t k) {
    std::vector<std::int64_t> values;
    for (const auto& corner : polygon)
        values.push_back(corner.attributes[k]);
    return values;
}

template <int N>
Points points_of(const std::vector<ScreenVertex<N>>& polygon) {
    Points points;
    for (const auto& corner : polygon)
        points.push_back({corner.x, corner.y});
    return points;
}

inline SubPixel top_of(const Points& points) {
    return std::min_element(points.begin(), points.end(),
                            [](ScreenPoint a, ScreenPoint b) { return a.y < b.y; })
        ->y;
}

/// A ramp's number in units of its format, with its fraction.
inline double units(std::int64_t ramp_value) {
    return static_cast<double>(ramp_value) / (1 << ramp_bits);
}

/// How far `ramp_value` is from the plane through a triangle's values, at the centre of a pixel, in
/// units. The plane is evaluated in whole numbers, without error.
inline double error_from_plane(std::int64_t ramp_value, const Points& t,
                               const std::vector<std::int64_t>& v, int column, int row) {
    const ScreenPoint c = centre_of(column, row);
    const __int128 area = cross(t[0], t[1], t[2]);
    const __int128 sum = __int128{v[0]} * cross(c, t[1], t[2]) +
                         __int128{v[1]} * cross(c, t[2], t[0]) +
                         __int128{v[2]} * cross(c, t[0], t[1]);
    const __int128 scale = 1 << ramp_bits;
    const auto difference = static_cast<long double>(ramp_value * area - sum * scale);
    return static_cast<double>(difference / static_cast<long double>(area * scale));
}

/// The bilinear rule as the textbook states it: values at the two crossings around the centre, and
/// between them in proportion.
inline long double bilinear_value(const Points& polygon, const std::vector<std::int64_t>& values,
                                  int column, int row) {
    const ScreenPoint centre = centre_of(column, row);
    std::vector<std::pair<long double, long double>> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        const bool down = polygon[i].y < polygon[next].y;
        const std::size_t top = down ? i : next;
        const std::size_t bottom = down ? next : i;
        if (centre.y < polygon[top].y || centre.y >= polygon[bottom].y) continue;
        const long double part = static_cast<long double>(centre.y - polygon[top].y) /
                                 static_cast<long double>(polygon[bottom].y - polygon[top].y);
        const auto between = [part](std::int64_t a, std::int64_t b) {
            return static_cast<long double>(a) + part * static_cast<long double>(b - a);
        };
        crossings.emplace_back(between(polygon[top].x, polygon[bottom].x),
                               between(values[top], values[bottom]));
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t right = 0;
    while (right + 1 < crossings.size() && crossings[right].first <= centre.x)
        ++right;
    const auto [x_a, a] = crossings[right - 1];
    const auto [x_b, b] = crossings[right];
    return a + (b - a) * (static_cast<long double>(centre.x) - x_a) / (x_b - x_a);
}

/// How far a whole number lies outside of the values at a polygon's corners.
inline std::int64_t beyond(std::int64_t number, const std::vector<std::int64_t>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return std::max({std::int64_t{0}, *low - number, number - *high});
}

}  // namespace scanlight::raster::laws
