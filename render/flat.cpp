#include "render/flat.h"

#include "render/painted.h"

namespace scanlight::render {

namespace {

/// World space.
glm::vec3 mean_corner(const PlacedMesh& placed, std::size_t face) {
    glm::vec3 sum(0.0f);
    const auto corners = placed.mesh->face(face);
    for (const std::uint32_t vertex : corners)
        sum += placed.points[vertex];
    return sum / static_cast<float>(corners.size());
}

/// Requires vertex colours.
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
    const shading::Surface<float> surface{point, placed_.face_normal_seen(face, side),
                                          frame_.view_from(point)};
    const shading::Material<float>& material = placed_.material_of(face);
    const glm::vec3 color = with_model(settings_, [&](const auto& model) {
        return with_paint(*placed_.mesh, [&](auto paint) {
            return illuminate(
                model, surface,
                painted_by<paint>(material, [&] { return mean_color(*placed_.mesh, face); }),
                frame_.lighting);
        });
    });
    return raster::Rgba(color, material.opacity);
}

}  // namespace scanlight::render
