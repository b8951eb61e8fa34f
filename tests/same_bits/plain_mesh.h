#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/mesh.h"

namespace scanlight::same_bits {

struct PlainCorner {
    glm::vec3 position;  // object space
    glm::vec3 normal;    // unit
    glm::vec3 color{1.0f};
};

struct PlainPolygon {
    std::vector<PlainCorner> corners;
    glm::vec3 normal;  // unit
    std::uint32_t material = 0;
};

enum class Colors { none, vertices };

/// Polygons as they are: each with vertices of its own, none left out, not even those without an
/// area, which `mesh::build` would drop.
mesh::Mesh plain_mesh(const std::vector<PlainPolygon>& polygons, std::size_t materials = 1,
                      Colors colors = Colors::none);

}  // namespace scanlight::same_bits
