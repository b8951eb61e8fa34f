#include "render/gouraud.h"

#include "render/painted.h"

namespace scanlight::render {

namespace {

/// The material of each vertex: a vertex belongs to the faces of one material only.
std::vector<std::uint32_t> vertex_materials(const mesh::Mesh& mesh) {
    std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f))
            result[vertex] = mesh.face_material[f];
    }
    return result;
}

}  // namespace

std::vector<glm::vec3> illuminate_vertices(const PlacedMesh& placed, const Frame& frame,
                                           const Settings& settings, Side side) {
    const mesh::Mesh& mesh = *placed.mesh;
    const float turn = side == Side::front ? 1.0f : -1.0f;
    const auto materials = vertex_materials(mesh);
    std::vector<glm::vec3> colors(mesh.vertices.size());
    with_model(settings, [&](auto model) {
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const shading::Surface<float> surface{placed.points[i], turn * placed.normals[i],
                                                  frame.view_from(placed.points[i])};
            const auto& material = (*placed.materials)[materials[i]];
            colors[i] = mesh.vertices.has_colors()
                            ? illuminate(model, surface, painted(material, mesh.vertices.color(i)),
                                         frame.lighting)
                            : illuminate(model, surface, material, frame.lighting);
        }
    });
    return colors;
}

}  // namespace scanlight::render
