#include "render/flat.h"

#include "render/painted.h"

namespace scanlight::render {

namespace {

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

}  // namespace

raster::Rgba FlatTechnique::polygon(std::size_t face, Side side) const {
    const glm::vec3 point = mean_corner(placed_, face);
    const glm::vec3 normal =
        side == Side::front ? placed_.face_normals[face] : -placed_.face_normals[face];
    const shading::Surface<float> surface{point, normal, frame_.view_from(point)};
    const auto& material = placed_.material_of(face);
    return with_model(settings_, [&](auto model) {
        const bool has_colors = placed_.mesh->vertices.has_colors();
        const glm::vec3 light =
            illuminate(model, surface,
                       has_colors ? painted(material, mean_color(*placed_.mesh, face)) : material,
                       frame_.lighting);
        return raster::Rgba(light, 1.0f);
    });
}

}  // namespace scanlight::render
