#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/raster/random_polygons.h"

namespace scanlight::raster::laws {

/// Polygons that share edges and together fill their outline.
struct Tiling {
    std::vector<Points> tiles;
    Points outline;
};

/// Triangles about the middle of a star: all edges meet in one point.
inline Tiling random_fan(Random& random, int extent) {
    Tiling fan{{}, random_star(random, extent)};
    const ScreenPoint middle{extent / 2, extent / 2};
    for (std::size_t i = 0; i < fan.outline.size(); ++i) {
        fan.tiles.push_back({middle, fan.outline[i], fan.outline[(i + 1) % fan.outline.size()]});
    }
    return fan;
}

/// A zigzag of triangles between two rows of corners.
inline Tiling random_strip(Random& random, int extent) {
    Tiling strip{{}, random_comb(random, extent)};
    const Points& o = strip.outline;
    const std::size_t last = o.size() - 1;
    for (std::size_t i = 0; i + 1 < o.size() / 2; ++i) {
        strip.tiles.push_back({o[i], o[last - i], o[i + 1]});
        strip.tiles.push_back({o[last - i], o[last - i - 1], o[i + 1]});
    }
    return strip;
}

/// One of 16 rotations, over a quarter turn: by 2 atan(step / 16), without a cosine.
struct Rotation {
    double cosine, sine;
};

inline Rotation rotation(int step) {
    const double t = step / 16.0;
    return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

/// Turns a point about the middle of [0, extent]², shrunk so that it stays inside.
inline ScreenPoint rotated(double x, double y, const Rotation& turn, int extent) {
    const double middle = 0.5 * extent;
    const double dx = (x - middle) * 0.7;
    const double dy = (y - middle) * 0.7;
    return {static_cast<SubPixel>(std::lrint(middle + dx * turn.cosine - dy * turn.sine)),
            static_cast<SubPixel>(std::lrint(middle + dx * turn.sine + dy * turn.cosine))};
}

/// Positive when d lies inside the circle through a, b, c (clockwise on the screen).
inline double in_circle(ScreenPoint a, ScreenPoint b, ScreenPoint c, ScreenPoint d) {
    const auto lifted = [d](ScreenPoint p) {
        const double x = p.x - d.x;
        const double y = p.y - d.y;
        return x * x + y * y;
    };
    return lifted(a) * static_cast<double>(cross(d, b, c)) +
           lifted(b) * static_cast<double>(cross(d, c, a)) +
           lifted(c) * static_cast<double>(cross(d, a, b));
}

/// How the cells of a grid are cut.
enum class Cut { none, random, delaunay };

inline void add_cell(Tiling& grid, const Points& q, Cut cut, Random& random) {
    if (cut == Cut::none) {
        grid.tiles.push_back(q);
        return;
    }
    const bool other =
        cut == Cut::random ? random.one_in(2) : in_circle(q[0], q[1], q[2], q[3]) > 0;
    if (other) {
        grid.tiles.push_back({q[0], q[1], q[3]});
        grid.tiles.push_back({q[1], q[2], q[3]});
    } else {
        grid.tiles.push_back({q[0], q[1], q[2]});
        grid.tiles.push_back({q[2], q[3], q[0]});
    }
}

/// A square of `cells` x `cells` cells with shaken corners, turned. Corners move by less than a
/// quarter of a cell, which keeps cells convex.
inline Tiling random_grid(Random& random, int extent, int cells, Cut cut, const Rotation& turn) {
    const double cell = static_cast<double>(extent) / cells;
    const auto shaken = [&](int i) {
        const bool border = i == 0 || i == cells;
        return (i + (border ? 0.0 : random.between(-1000, 1000) / 4100.0)) * cell;
    };
    std::vector<Points> corners(static_cast<std::size_t>(cells) + 1);
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const double x = shaken(i);
            corners[static_cast<std::size_t>(j)].push_back(rotated(x, shaken(j), turn, extent));
        }
    }
    Tiling grid;
    const auto n = static_cast<std::size_t>(cells);
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            add_cell(grid,
                     {corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]},
                     cut, random);
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        grid.outline.push_back(corners[0][i]);
    for (std::size_t j = 0; j < n; ++j)
        grid.outline.push_back(corners[j][n]);
    for (std::size_t i = n; i > 0; --i)
        grid.outline.push_back(corners[n][i]);
    for (std::size_t j = n; j > 0; --j)
        grid.outline.push_back(corners[j][0]);
    return grid;
}

/// Whether no other corner lies in the triangle that corner `tip` makes with its neighbours, which
/// can then be cut off.
inline bool is_ear(const Points& polygon, std::size_t tip, bool clockwise) {
    const std::size_t n = polygon.size();
    const ScreenPoint a = polygon[(tip + n - 1) % n];
    const ScreenPoint b = polygon[tip];
    const ScreenPoint c = polygon[(tip + 1) % n];
    const int sign = clockwise ? 1 : -1;
    if (sign * cross(a, b, c) <= 0) return false;
    for (std::size_t i = 0; i + 3 < n; ++i) {
        const ScreenPoint p = polygon[(tip + 2 + i) % n];
        if (sign * cross(a, b, p) >= 0 && sign * cross(b, c, p) >= 0 && sign * cross(c, a, p) >= 0)
            return false;
    }
    return true;
}

inline std::int64_t area_of(const Points& polygon) {
    std::int64_t area = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += cross(polygon[0], polygon[i], polygon[i + 1]);
    return area;
}

/// A triangulation by cutting off random ears; no tiles when corners touch edges, so that there is
/// no strict ear left.
inline Tiling random_triangulation(Random& random, const Points& polygon) {
    Tiling result{{}, polygon};
    Points rest = polygon;
    const bool clockwise = area_of(polygon) > 0;
    while (rest.size() > 3) {
        const std::size_t n = rest.size();
        const auto start = static_cast<std::size_t>(random.between(0, static_cast<int>(n) - 1));
        std::size_t tried = 0;
        while (tried < n && !is_ear(rest, (start + tried) % n, clockwise))
            ++tried;
        if (tried == n) return {{}, polygon};
        const std::size_t tip = (start + tried) % n;
        result.tiles.push_back({rest[(tip + n - 1) % n], rest[tip], rest[(tip + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(tip));
    }
    result.tiles.push_back(rest);
    return result;
}

}  // namespace scanlight::raster::laws
