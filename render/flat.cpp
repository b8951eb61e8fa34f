#include "render/flat.h"

namespace scanlight::render {

glm::vec3 mean_corner(const PlacedMesh& placed, std::size_t face) {
    glm::vec3 sum(0.0f);
    const auto corners = placed.mesh->face(face);
    for (const std::uint32_t vertex : corners)
        sum += placed.points[vertex];
    return sum / static_cast<float>(corners.size());
}

glm::vec3 mean_color(const mesh::Mesh& mesh, std::size_t face) {
    glm::vec3 sum(0.0f);
    const auto corners = mesh.face(face);
    for (const std::uint32_t vertex : corners)
        sum += mesh.vertices.color(vertex);
    return sum / static_cast<float>(corners.size());
}

}  // namespace scanlight::render
