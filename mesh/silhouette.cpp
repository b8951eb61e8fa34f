#include "mesh/silhouette.h"

#include <glm/geometric.hpp>

#include "mesh/newell.h"

namespace scanlight::mesh {

namespace {

std::vector<glm::vec3> corners_of(const Mesh& mesh, std::size_t face) {
    std::vector<glm::vec3> corners;
    for (const std::uint32_t v : mesh.face(face))
        corners.push_back(mesh.vertices.position(v));
    return corners;
}

glm::dvec3 mean(const std::vector<glm::vec3>& points) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3& point : points)
        sum += glm::dvec3(point);
    return sum / static_cast<double>(points.size());
}

Facing sign_of(double distance) {
    return static_cast<Facing>((distance > 0.0 ? 1 : 0) - (distance < 0.0 ? 1 : 0));
}

}  // namespace

SilhouetteFinder::SilhouetteFinder(const Mesh& mesh)
    : edges_(edges_of(mesh)), bounds_(bounding_box(mesh)) {
    planes_.reserve(mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = corners_of(mesh, f);
        const glm::dvec3 normal = area_vector(corners);
        const glm::dvec3 point = corners.size() == 3 ? glm::dvec3(corners.front()) : mean(corners);
        planes_.push_back({normal, glm::dot(normal, point)});
    }
}

std::vector<Facing> SilhouetteFinder::facing(const glm::dvec4& viewpoint) const {
    std::vector<Facing> result(planes_.size());
    for (std::size_t f = 0; f < result.size(); ++f) {
        const auto& [normal, offset] = planes_[f];
        result[f] = sign_of(glm::dot(normal, glm::dvec3(viewpoint)) - viewpoint.w * offset);
    }
    return result;
}

Silhouette SilhouetteFinder::from(const glm::dvec4& viewpoint) const {
    Silhouette result{facing(viewpoint), {}};
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        std::int32_t multiplicity = 0;
        for (const auto& [face, direction] : edges_.uses_of(e))
            multiplicity += direction * static_cast<std::int32_t>(result.facing[face]);
        if (multiplicity != 0) result.edges.push_back({edges_.from[e], edges_.to[e], multiplicity});
    }
    return result;
}

}  // namespace scanlight::mesh
