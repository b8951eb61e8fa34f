#include "mesh/flat_shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "mesh/add_face.h"
#include "mesh/circle.h"
#include "mesh/file_error.h"
#include "mesh/newell.h"

namespace scanlight::mesh {
namespace {

using Corner = PolygonSoup::Corner;

/// One face with these corners, in their order.
PolygonSoup one_face(std::span<const glm::dvec2> corners) {
    PolygonSoup soup;
    std::vector<Corner> face;
    for (const glm::dvec2& p : corners) {
        const auto i = static_cast<std::uint32_t>(face.size());
        soup.positions.emplace_back(p.x, p.y, 0.0);
        soup.uvs.emplace_back(0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y);
        face.push_back({.position = i, .uv = i});
    }
    add_face(soup, face);
    return soup;
}

/// Positive if the face looks along +z.
double facing(const PolygonSoup& soup) {
    return area_vector(soup.positions).z;
}

/// One polygon about the z axis from the top on, counter-clockwise; its radius alternates.
PolygonSoup polygon(std::uint32_t count, const std::array<double, 2>& radius) {
    std::vector<glm::dvec2> corners;
    for (const Direction& d : circle(count)) {
        const double r = radius[corners.size() % 2];
        corners.emplace_back(-r * d.sine, r * d.cosine);
    }
    return one_face(corners);
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

PolygonSoup flat_polygon(std::span<const glm::dvec2> corners) {
    std::vector<glm::dvec2> order(corners.begin(), corners.end());
    PolygonSoup soup = one_face(order);
    if (facing(soup) == 0.0) throw FileError("shape polygon: its corners enclose no area");
    for (std::size_t i = 0; facing(soup) < 0.0 && i < 2 * order.size(); ++i) {
        if (i % 2 == 0) {
            std::reverse(order.begin() + 1, order.end());
        } else {
            std::rotate(order.begin(), order.begin() + 1, order.end());
        }
        soup = one_face(order);
    }
    return soup;
}

}  // namespace scanlight::mesh
