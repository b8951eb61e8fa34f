#include "mesh/face_planes.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace scanlight::mesh {

namespace {

/// Of u and v.
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

bool is_finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// With the mean that `values` have at the corners.
glm::vec4 linear_function(const Mesh& mesh, std::size_t face, const glm::dvec3& gradient,
                          const std::vector<float>& values) {
    double sum = 0.0;
    for (const std::uint32_t v : mesh.face(face)) {
        const glm::dvec3 position(mesh.vertices.position(v));
        sum += static_cast<double>(values[v]) - glm::dot(gradient, position);
    }
    const double at_origin = sum / static_cast<double>(mesh.face(face).size());
    const glm::vec4 function(glm::dvec4(gradient, at_origin));
    return is_finite(function) ? function : glm::vec4(0.0f);
}

float offset_of(const Mesh& mesh, std::size_t face) {
    const glm::dvec3 corner(mesh.vertices.position(mesh.face(face).front()));
    return static_cast<float>(glm::dot(glm::dvec3(mesh.face_normals[face]), corner));
}

}  // namespace

void find_face_planes(Mesh& mesh) {
    mesh.face_offset.clear();
    mesh.face_u.clear();
    mesh.face_v.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        mesh.face_offset.push_back(offset_of(mesh, f));
        if (!mesh.vertices.has_uvs()) continue;
        const Sums sums = sums_of(mesh, f);
        const auto& [u, v] = sums.gradients;
        mesh.face_u.push_back(linear_function(mesh, f, u / sums.area, mesh.vertices.u));
        mesh.face_v.push_back(linear_function(mesh, f, v / sums.area, mesh.vertices.v));
    }
}

}  // namespace scanlight::mesh
