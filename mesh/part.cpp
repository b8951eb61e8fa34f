#include "mesh/part.h"

namespace scanlight::mesh {

namespace {

template <class Value>
std::vector<Value> picked(const std::vector<Value>& all, std::span<const std::uint32_t> faces) {
    std::vector<Value> result;
    if (all.empty()) return result;
    result.reserve(faces.size());
    for (const std::uint32_t f : faces)
        result.push_back(all[f]);
    return result;
}

}  // namespace

Mesh part(const Mesh& mesh, std::span<const std::uint32_t> faces) {
    Mesh result;
    result.vertices = mesh.vertices;
    result.materials = mesh.materials;
    for (const std::uint32_t f : faces) {
        const auto corners = mesh.face(f);
        result.corners.insert(result.corners.end(), corners.begin(), corners.end());
        result.face_begin.push_back(static_cast<std::uint32_t>(result.corners.size()));
    }
    result.face_normals = picked(mesh.face_normals, faces);
    result.face_offset = picked(mesh.face_offset, faces);
    result.face_u = picked(mesh.face_u, faces);
    result.face_v = picked(mesh.face_v, faces);
    result.face_material = picked(mesh.face_material, faces);
    result.face_id = picked(mesh.face_id, faces);
    return result;
}

}  // namespace scanlight::mesh
