#include "mesh/bounds.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scanlight::mesh {

Box bounding_box(const Mesh& mesh) {
    const Vertices& vertices = mesh.vertices;
    if (vertices.size() == 0) return {};
    Box box{vertices.position(0), vertices.position(0)};
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        const glm::dvec3 p = vertices.position(i);
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
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
