#include "mesh/flat_shapes.h"

#include <array>
#include <vector>

#include "mesh/add_face.h"
#include "mesh/circle.h"

namespace scanlight::mesh {
namespace {

using Corner = PolygonSoup::Corner;

/// One polygon about the z axis from the top on, counter-clockwise; its radius alternates.
PolygonSoup polygon(std::uint32_t corners, const std::array<double, 2>& radius) {
    PolygonSoup soup;
    std::vector<Corner> face;
    for (const Direction& d : circle(corners)) {
        const auto i = static_cast<std::uint32_t>(face.size());
        const double x = -radius[i % 2] * d.sine;
        const double y = radius[i % 2] * d.cosine;
        soup.positions.emplace_back(x, y, 0.0);
        soup.uvs.emplace_back(0.5 + 0.5 * x, 0.5 + 0.5 * y);
        face.push_back({.position = i, .uv = i});
    }
    add_face(soup, face);
    return soup;
}

}  // namespace

PolygonSoup plane(std::uint32_t n) {
    PolygonSoup soup;
    for (std::uint32_t row = 0; row <= n; ++row) {
        for (std::uint32_t column = 0; column <= n; ++column) {
            const double u = double(column) / n;
            const double v = double(row) / n;
            soup.positions.emplace_back(2.0 * u - 1.0, 0.0, 2.0 * v - 1.0);
            soup.uvs.emplace_back(u, 1.0 - v);
        }
    }
    add_quads(soup, n, n, [n](std::uint32_t column, std::uint32_t row) {
        const std::uint32_t i = row * (n + 1) + column;
        return Corner{.position = i, .uv = i};
    });
    return soup;
}

PolygonSoup regular_polygon(std::uint32_t n) {
    return polygon(n, {1.0, 1.0});
}

PolygonSoup star(std::uint32_t points) {
    return polygon(2 * points, {1.0, 0.4});
}

}  // namespace scanlight::mesh
