#include "apps/peers/surfaces.h"

#include <array>

#include "mesh/add_face.h"
#include "mesh/round_shapes.h"
#include "mesh/trigonometry.h"

namespace scanlight::peers {

namespace {

double hills(const glm::dvec3& p) {
    return mesh::sine(5.0 * p.x + 1.0) * mesh::sine(6.0 * p.y) * mesh::sine(7.0 * p.z + 2.0) +
           0.2 * mesh::sine(20.0 * p.x) * mesh::sine(20.0 * p.y + 1.0);
}

/// From -1 to 1 in `count` steps.
double across(std::uint32_t i, std::uint32_t count) {
    return 2.0 * i / count - 1.0;
}

constexpr std::array<glm::dvec2, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

void add_layer(mesh::PolygonSoup& soup, const glm::dvec2& half_size, double z, double tilt) {
    for (const glm::dvec2& side : square) {
        const auto i = static_cast<std::uint32_t>(soup.positions.size());
        soup.positions.emplace_back(glm::dvec3(side * half_size, z));
        soup.normals.emplace_back(glm::dvec3(side * tilt, 1.0));
        soup.uvs.emplace_back(0.5 + 0.5 * side);
        soup.corners.push_back({i, i, i});
    }
    soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}

}  // namespace

mesh::PolygonSoup displaced_sphere(std::uint32_t rings) {
    mesh::PolygonSoup soup = mesh::uv_sphere(2 * rings, rings + 1);
    for (glm::vec3& p : soup.positions)
        p *= static_cast<float>(1.0 + 0.14 * hills(glm::dvec3(p)));
    return soup;
}

mesh::PolygonSoup wavy_sheet(std::uint32_t columns, std::uint32_t rows, double aspect) {
    mesh::PolygonSoup soup;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const glm::dvec2 p(aspect * across(column, columns), across(row, rows));
            const double z = 0.03 * mesh::sine(9.0 * p.x) * mesh::sine(11.0 * p.y + 1.0);
            soup.positions.emplace_back(glm::dvec3(p, z));
            soup.uvs.emplace_back(0.5 + 0.5 * p);
        }
    }
    mesh::add_quads(soup, columns, rows, [=](std::uint32_t column, std::uint32_t row) {
        const std::uint32_t i = (rows - row) * (columns + 1) + column;  // theirs run down
        return mesh::PolygonSoup::Corner{i, mesh::PolygonSoup::none, i};
    });
    return soup;
}

mesh::PolygonSoup full_screen_layers(std::uint32_t count, LayerOrder order, double aspect,
                                     double distance) {
    mesh::PolygonSoup soup;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t from_back = order == LayerOrder::back_to_front ? i : count - 1 - i;
        const double z = 0.1 * from_back;
        const double half_height = (distance - z) / distance;
        add_layer(soup, {aspect * half_height, half_height}, z, 0.25 + 0.05 * from_back);
    }
    return soup;
}

}  // namespace scanlight::peers
