#include "mesh/half_edge.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/edge_pairs.h"
#include "mesh/fans.h"

namespace scanlight::mesh {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

VertexHandle vertex_handle(std::uint32_t vertex) {
    return VertexHandle(static_cast<int>(vertex));
}

/// Fills an OpenMesh surface in place, since OpenMesh's meshes copy when they should move.
class SurfaceBuilder {
public:
    /// Begins with a vertex for every fan.
    SurfaceBuilder(Connectivity& surface, const PolygonSoup& soup, const Polygons& polygons,
                   const Fans& fans)
        : surface_(surface), soup_(soup), polygons_(polygons), fans_(fans) {
        surface_.reserve(fans.vertex_count(), polygons.corner_count() / 2 + fans.vertex_count() / 2,
                         polygons.face_count());
        for (const std::uint32_t point : fans.point) {
            add_vertex(point);
        }
    }

    void add_face(std::uint32_t face) {
        corners_.clear();
        for (std::uint32_t c = polygons_.begin[face]; c < polygons_.begin[face + 1]; ++c) {
            corners_.push_back(vertex_handle(fans_.vertex[c]));
        }
        FaceHandle added = surface_.add_face(corners_.data(), corners_.size());
        if (!added.is_valid()) added = add_apart(face);
        const glm::dvec3& n = polygons_.normals[face];
        surface_.set_normal(added, {n.x, n.y, n.z});
        name_corners(added, polygons_.begin[face]);
    }

    std::size_t refused_faces() const { return refused_faces_; }

private:
    VertexHandle add_vertex(std::uint32_t point) {
        const glm::vec3& p = soup_.positions[point];
        return surface_.add_vertex({p.x, p.y, p.z});
    }

    /// The net below the splitting: new vertices always take a face.
    FaceHandle add_apart(std::uint32_t face) {
        ++refused_faces_;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            corners_[i] = add_vertex(polygons_.point[polygons_.begin[face] + i]);
        }
        return surface_.add_face(corners_.data(), corners_.size());
    }

    /// OpenMesh gives a face the half-edge that enters its first corner.
    void name_corners(FaceHandle face, std::uint32_t first_corner) {
        HalfedgeHandle leaving = surface_.next_halfedge_handle(surface_.halfedge_handle(face));
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            surface_.data(leaving).corner = first_corner + static_cast<std::uint32_t>(i);
            leaving = surface_.next_halfedge_handle(leaving);
        }
    }

    Connectivity& surface_;
    const PolygonSoup& soup_;
    const Polygons& polygons_;
    const Fans& fans_;
    std::vector<VertexHandle> corners_;  // of the face at hand
    std::size_t refused_faces_ = 0;
};

std::size_t count_used_points(const PolygonSoup& soup, const Polygons& polygons) {
    std::vector<bool> used(soup.positions.size(), false);
    for (const std::uint32_t point : polygons.point) {
        used[point] = true;
    }
    return static_cast<std::size_t>(std::ranges::count(used, true));
}

/// What half-edges cannot hold is split: the vertices that are left, and why.
struct Splitting {
    Fans fans;
    std::size_t left_over_faces;
};

Splitting split(const PolygonSoup& soup, const Polygons& polygons) {
    EdgePairs pairs = pair_edges(soup, polygons);
    Fans fans = separate_double_edges(polygons, pairs, find_fans(polygons, pairs));
    return {std::move(fans), static_cast<std::size_t>(std::ranges::count(pairs.left_over, true))};
}

/// Sets of faces that grow together, each a tree. Tarjan 1975, with halved paths.
class FaceSets {
public:
    explicit FaceSets(std::size_t faces) : parent_(faces), count_(faces) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    void join(FaceHandle a, FaceHandle b) {
        const std::uint32_t root_a = root(a);
        const std::uint32_t root_b = root(b);
        if (root_a == root_b) return;
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
        --count_;
    }

    std::size_t count() const { return count_; }

private:
    std::uint32_t root(FaceHandle handle) {
        auto face = static_cast<std::uint32_t>(handle.idx());
        while (parent_[face] != face) {
            parent_[face] = parent_[parent_[face]];
            face = parent_[face];
        }
        return face;
    }

    std::vector<std::uint32_t> parent_;
    std::size_t count_;
};

}  // namespace

HalfEdgeMesh half_edge_mesh(const PolygonSoup& soup) {
    HalfEdgeMesh mesh;
    mesh.polygons = drawable_polygons(soup);
    const Splitting splitting = split(soup, mesh.polygons);
    mesh.polygons.forget_neighbours();

    SurfaceBuilder builder(mesh.surface, soup, mesh.polygons, splitting.fans);
    for (std::uint32_t face = 0; face < mesh.polygons.face_count(); ++face) {
        builder.add_face(face);
    }
    mesh.polygons.forget_normals();
    const std::size_t used_points = count_used_points(soup, mesh.polygons);
    mesh.isolated_points = soup.positions.size() - used_points;
    mesh.split_faces = splitting.left_over_faces + builder.refused_faces();
    mesh.split_vertices = mesh.surface.n_vertices() - used_points;
    return mesh;
}

std::vector<glm::vec3> face_normals(const HalfEdgeMesh& mesh) {
    std::vector<glm::vec3> normals;
    normals.reserve(mesh.surface.n_faces());
    for (const auto face : mesh.surface.faces())
        normals.emplace_back(normal(mesh.surface, face));
    return normals;
}

std::size_t count_components(const HalfEdgeMesh& mesh) {
    const Connectivity& surface = mesh.surface;
    FaceSets sets(surface.n_faces());
    for (const auto edge : surface.edges()) {
        const FaceHandle a = surface.face_handle(surface.halfedge_handle(edge, 0));
        const FaceHandle b = surface.face_handle(surface.halfedge_handle(edge, 1));
        if (a.is_valid() && b.is_valid()) sets.join(a, b);
    }
    return sets.count();
}

std::size_t count_boundary_edges(const HalfEdgeMesh& mesh) {
    const auto on_boundary = [&](EdgeHandle edge) { return mesh.surface.is_boundary(edge); };
    return static_cast<std::size_t>(
        std::count_if(mesh.surface.edges_begin(), mesh.surface.edges_end(), on_boundary));
}

}  // namespace scanlight::mesh
