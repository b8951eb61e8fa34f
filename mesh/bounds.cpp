#include "mesh/bounds.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace scanlight::mesh {

Box bounding_box(const Mesh& mesh) {
    const Vertices& vertices = mesh.vertices;
    if (vertices.size() == 0) return {glm::dvec3(0.0), glm::dvec3(0.0)};
    Box box;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        box.include(vertices.position(i));
    return box;
}

Ball bounding_ball(const Mesh& mesh) {
    const glm::dvec3 center = bounding_box(mesh).center();
    double farthest = 0.0;  // squared
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::dvec3 to_vertex = glm::dvec3(mesh.vertices.position(i)) - center;
        farthest = std::max(farthest, glm::dot(to_vertex, to_vertex));
    }
    return {center, std::sqrt(farthest)};
}

}  // namespace scanlight::mesh
