#include "mesh/face_planes.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace scanlight::mesh {

namespace {

struct Gradients {
    glm::dvec3 u{0.0}, v{0.0};
};

/// Twice the gradients times the face's area, and twice that area.
struct Sums {
    Gradients gradients;
    double area = 0.0;
};

Sums sums_of(const Mesh& mesh, std::size_t face) {
    const auto corners = mesh.face(face);
    const glm::dvec3 normal(mesh.face_normals[face]);
    const glm::dvec3 first(mesh.vertices.position(corners.front()));
    Sums sums;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i];
        const std::uint32_t b = corners[i + 1 < corners.size() ? i + 1 : 0];
        const glm::dvec3 begin = glm::dvec3(mesh.vertices.position(a)) - first;
        const glm::dvec3 end = glm::dvec3(mesh.vertices.position(b)) - first;
        const glm::dvec3 outward = glm::cross(end - begin, normal);
        const glm::dvec2 uv = glm::dvec2(mesh.vertices.uv(a)) + glm::dvec2(mesh.vertices.uv(b));
        sums.gradients.u += uv.x * outward;
        sums.gradients.v += uv.y * outward;
        sums.area += glm::dot(glm::cross(begin, end), normal);
    }
    return sums;
}

glm::vec3 finite_or_zero(const glm::dvec3& v) {
    const glm::vec3 result(v);
    const bool is_finite =
        std::isfinite(result.x) && std::isfinite(result.y) && std::isfinite(result.z);
    return is_finite ? result : glm::vec3(0.0f);
}

float offset_of(const Mesh& mesh, std::size_t face) {
    const glm::dvec3 corner(mesh.vertices.position(mesh.face(face).front()));
    return static_cast<float>(glm::dot(glm::dvec3(mesh.face_normals[face]), corner));
}

}  // namespace

void find_face_planes(Mesh& mesh) {
    mesh.face_offset.clear();
    mesh.face_grad_u.clear();
    mesh.face_grad_v.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        mesh.face_offset.push_back(offset_of(mesh, f));
        if (!mesh.vertices.has_uvs()) continue;
        const Sums sums = sums_of(mesh, f);
        mesh.face_grad_u.push_back(finite_or_zero(sums.gradients.u / sums.area));
        mesh.face_grad_v.push_back(finite_or_zero(sums.gradients.v / sums.area));
    }
}

}  // namespace scanlight::mesh
