#include "mesh/triangulate.h"

#include "mesh/ear_clipping.h"
#include "mesh/face_planes.h"

namespace scanlight::mesh {
namespace {

/// Adds the face's triangles to `cut`, which has the vertices already.
void append_triangles(Mesh& cut, const Mesh& mesh, std::size_t face) {
    const std::span corners = mesh.face(face);
    std::vector<glm::vec3> polygon;
    for (const std::uint32_t corner : corners) {
        polygon.push_back(mesh.vertices.position(corner));
    }
    for (const auto& triangle : cut_ears(polygon)) {
        for (const std::uint32_t place : triangle) {
            cut.corners.push_back(corners[place]);
        }
        cut.face_begin.push_back(static_cast<std::uint32_t>(cut.corners.size()));
        cut.face_normals.push_back(mesh.face_normals[face]);
        cut.face_material.push_back(mesh.face_material[face]);
        cut.face_id.push_back(mesh.face_id[face]);
    }
}

}  // namespace

Mesh triangulated(const Mesh& mesh) {
    Mesh cut;
    cut.vertices = mesh.vertices;
    cut.materials = mesh.materials;
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        append_triangles(cut, mesh, face);
    }
    find_face_planes(cut);
    return cut;
}

}  // namespace scanlight::mesh
