#include "tests/same_bits/plain_mesh.h"

#include "mesh/face_planes.h"

namespace scanlight::same_bits {

namespace {

void add_vertex(mesh::Vertices& v, const PlainCorner& corner, Colors colors) {
    v.x.push_back(corner.position.x);
    v.y.push_back(corner.position.y);
    v.z.push_back(corner.position.z);
    v.nx.push_back(corner.normal.x);
    v.ny.push_back(corner.normal.y);
    v.nz.push_back(corner.normal.z);
    if (colors == Colors::none) return;
    v.red.push_back(corner.color.r);
    v.green.push_back(corner.color.g);
    v.blue.push_back(corner.color.b);
}

}  // namespace

mesh::Mesh plain_mesh(const std::vector<PlainPolygon>& polygons, std::size_t materials,
                      Colors colors) {
    mesh::Mesh mesh;
    mesh.materials.resize(materials);
    for (const PlainPolygon& polygon : polygons) {
        for (const PlainCorner& corner : polygon.corners) {
            mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            add_vertex(mesh.vertices, corner, colors);
        }
        mesh.face_id.push_back(static_cast<std::uint32_t>(mesh.face_id.size()));
        mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.face_normals.push_back(polygon.normal);
        mesh.face_material.push_back(polygon.material);
    }
    mesh::find_face_planes(mesh);
    return mesh;
}

}  // namespace scanlight::same_bits
