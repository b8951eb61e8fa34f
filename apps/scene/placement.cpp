#include "apps/scene/placement.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "mesh/trigonometry.h"

namespace scanlight::apps {

namespace {

/// Rodrigues 1840: R = cos(a) I + (1 - cos(a)) u uT + sin(a) [u]x.
glm::dmat3 rotation(const Turn& turn) {
    const double angle = turn.angle_deg * mesh::pi / 180.0;
    const double c = mesh::cosine(angle);
    const double s = mesh::sine(angle);
    const glm::dvec3 u = turn.axis / std::sqrt(glm::dot(turn.axis, turn.axis));
    const glm::dmat3 cross(0.0, u.z, -u.y, -u.z, 0.0, u.x, u.y, -u.x, 0.0);
    return glm::dmat3(c) + glm::outerProduct(u, u * (1.0 - c)) + cross * s;
}

}  // namespace

glm::dmat4 matrix_of(const Placement& placement) {
    if (placement.matrix) return *placement.matrix;
    glm::dmat3 linear(1.0);
    for (int k = 0; k < 3; ++k)
        linear[k][k] = placement.scale[k];
    for (const Turn& turn : placement.turns)
        linear = rotation(turn) * linear;
    glm::dmat4 matrix(linear);
    matrix[3] = glm::dvec4(placement.translate, 1.0);
    return matrix;
}

mesh::Box placed_box(const mesh::Mesh& mesh, const glm::dmat4& world_from_object) {
    mesh::Box box;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        box.include(
            glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(mesh.vertices.position(i)), 1.0)));
    return box;
}

}  // namespace scanlight::apps
