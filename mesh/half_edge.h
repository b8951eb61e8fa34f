#pragma once

// Private to this room: the only header that shows OpenMesh. Public headers name HalfEdgeMesh
// without including it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <glm/vec3.hpp>

#include "mesh/polygons.h"

namespace scanlight::mesh {

/// Points as the soup has them; normals in double, so that a mean of them is right to the last bit
/// of a float.
struct HalfEdgeTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3f;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::Normal);
    HalfedgeTraits {
        std::uint32_t corner = PolygonSoup::none;  // of `polygons`; none on the boundary
    };
};

using Connectivity = OpenMesh::PolyMesh_ArrayKernelT<HalfEdgeTraits>;

/// Invariant: face f of `surface` is face f of `polygons`, and the half-edge that leaves a corner
/// knows it. Every vertex of `surface` is one fan. Neighbours and normals are those of `surface`;
/// `polygons` has forgotten them.
struct HalfEdgeMesh {
    Connectivity surface;
    Polygons polygons;
    std::size_t split_faces = 0;
    std::size_t split_vertices = 0;
    std::size_t isolated_points = 0;
};

/// The drawable faces of a soup as a half-edge mesh, split where it could not hold them.
HalfEdgeMesh half_edge_mesh(const PolygonSoup& soup);

/// One unit normal a face.
std::vector<glm::vec3> face_normals(const HalfEdgeMesh& mesh);

/// Pieces that hang together over edges.
std::size_t count_components(const HalfEdgeMesh& mesh);

std::size_t count_boundary_edges(const HalfEdgeMesh& mesh);

inline glm::dvec3 point(const Connectivity& surface, OpenMesh::VertexHandle vertex) {
    const OpenMesh::Vec3f& p = surface.point(vertex);
    return {p[0], p[1], p[2]};
}

inline glm::dvec3 normal(const Connectivity& surface, OpenMesh::FaceHandle face) {
    const OpenMesh::Vec3d& n = surface.normal(face);
    return {n[0], n[1], n[2]};
}

}  // namespace scanlight::mesh
