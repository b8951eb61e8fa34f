#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "tests/raster/random_polygons.h"

namespace scanlight::raster::laws {

inline ScreenPoint centre_of(int column, int row) {
    return {column * subpixels + half_pixel, row * subpixels + half_pixel};
}

/// Whether a polygon covers a pixel, from first principles: the pixel's centre, moved to the right
/// by next to nothing, and down by next to nothing of that, has an odd number of edges to its left.
/// Moved like this it lies on no edge, and a centre on an edge falls to the polygon right of it or,
/// if the edge is horizontal, below it.
inline bool covers(const Points& polygon, int column, int row) {
    const ScreenPoint centre = centre_of(column, row);
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        ScreenPoint top = polygon[i];
        ScreenPoint bottom = polygon[(i + 1) % polygon.size()];
        if (top.y > bottom.y) std::swap(top, bottom);
        const bool beside = top.y <= centre.y && centre.y < bottom.y;
        if (beside && cross(top, bottom, centre) <= 0) inside = !inside;
    }
    return inside;
}

/// The same for a triangle as graphics hardware states it: inside of three edge functions, where
/// zero counts on top and left edges only.
inline bool covers_by_edge_functions(const Points& triangle, int column, int row) {
    const ScreenPoint centre = centre_of(column, row);
    const std::int64_t turn = cross(triangle[0], triangle[1], triangle[2]);
    if (turn == 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenPoint from = triangle[turn > 0 ? i : (i + 1) % 3];
        const ScreenPoint to = triangle[turn > 0 ? (i + 1) % 3 : i];
        const std::int64_t side = cross(from, to, centre);
        // With the inside to the right of the way, left edges go up and top edges go right.
        const bool top_or_left = to.y < from.y || (to.y == from.y && to.x > from.x);
        if (side < 0 || (side == 0 && !top_or_left)) return false;
    }
    return true;
}

/// Whether a centre lies exactly on the polygon's boundary.
inline bool on_boundary(const Points& polygon, int column, int row) {
    const ScreenPoint c = centre_of(column, row);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenPoint a = polygon[i];
        const ScreenPoint b = polygon[(i + 1) % polygon.size()];
        const bool in_box = std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) &&
                            std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
        if (in_box && cross(a, b, c) == 0) return true;
    }
    return false;
}

}  // namespace scanlight::raster::laws
