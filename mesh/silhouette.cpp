#include "mesh/silhouette.h"

#include <glm/geometric.hpp>

#include "mesh/newell.h"

namespace scanlight::mesh {

namespace {

struct Outline {
    std::vector<glm::vec3> corners;

    void read(const Mesh& mesh, std::size_t face) {
        corners.clear();
        for (const std::uint32_t v : mesh.face(face))
            corners.push_back(mesh.vertices.position(v));
    }

    glm::dvec3 centre() const {
        glm::dvec3 sum(0.0);
        for (const glm::vec3& corner : corners)
            sum += glm::dvec3(corner);
        return sum / static_cast<double>(corners.size());
    }
};

Facing sign_of(double distance) {
    if (distance > 0.0) return Facing::front;
    return distance < 0.0 ? Facing::back : Facing::edge_on;
}

Facing facing_of(const Outline& face, const glm::dvec4& viewpoint) {
    // Seen from a corner, not from the origin: far from it a small face keeps its side.
    const glm::dvec3 centre =
        face.corners.size() == 3 ? glm::dvec3(face.corners.front()) : face.centre();
    return sign_of(
        glm::dot(area_vector(face.corners), glm::dvec3(viewpoint) - viewpoint.w * centre));
}

}  // namespace

std::vector<Facing> facing(const Mesh& mesh, const glm::dvec4& viewpoint) {
    std::vector<Facing> result(mesh.face_count());
    Outline outline;
    for (std::size_t f = 0; f < result.size(); ++f) {
        outline.read(mesh, f);
        result[f] = facing_of(outline, viewpoint);
    }
    return result;
}

std::vector<SilhouetteEdge> silhouette(const Edges& edges, const std::vector<Facing>& facing) {
    std::vector<SilhouetteEdge> result;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        std::int32_t multiplicity = 0;
        for (const auto& [face, direction] : edges.uses_of(e))
            multiplicity += direction * static_cast<std::int32_t>(facing[face]);
        if (multiplicity != 0) result.push_back({edges.from[e], edges.to[e], multiplicity});
    }
    return result;
}

}  // namespace scanlight::mesh
