#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "mesh/edges.h"
#include "mesh/silhouette.h"
#include "raster/clip_volume.h"
#include "render/frame.h"
#include "render/placed_mesh.h"

namespace scanlight::render {

/// A light for geometry, world space, homogeneous: its place (w = 1), or the direction towards it
/// (w = 0).
glm::dvec4 homogeneous(const shading::Light<float>& light);

/// The shadow volumes of all faces of an object together: a closed surface round the points that
/// the object hides from a light (Crow 1977, "Shadow algorithms for computer graphics", SIGGRAPH).
/// It begins with a cap, the faces themselves, all turned to the light; sides go from the edges
/// that are left over (see `mesh::silhouette`) away from the light to infinity, where an end closes
/// it. Points at infinity are homogeneous points with w = 0.
class ShadowVolume {
public:
    ShadowVolume(const Object& object, const PlacedMesh& placed, const mesh::Edges& edges,
                 const glm::dvec4& light, const Frame& frame);

    /// Calls `visit(corners, count, deep)` for each face, in clip space. Counter-clockwise corners
    /// show its outside; `count` is how often it is there, less than 0 where its inside is shown.
    template <class Visit>
    void for_each_face(Visit&& visit) const {
        for (std::size_t f = 0; f < facing_.size(); ++f)
            visit_caps(f, visit);
        for (const mesh::SilhouetteEdge& edge : silhouette_)
            visit_side(edge, visit);
    }

private:
    using Polygon = raster::BareClipPolygon;

    /// The face itself, and its image at the end.
    template <class Visit>
    void visit_caps(std::size_t face, Visit& visit) const {
        if (facing_[face] == mesh::Facing::edge_on) return;
        const std::int32_t count = orientation_ * static_cast<std::int32_t>(facing_[face]);
        visit(polygon_of(face, placed_.clip), count, deep_);
        if (!ends_in_one_point_) visit(polygon_of(face, ends_), -count, raster::Deep::beyond);
    }

    template <class Visit>
    void visit_side(const mesh::SilhouetteEdge& edge, Visit& visit) const {
        const std::int32_t count = orientation_ * edge.multiplicity;
        const auto from = corner(placed_.clip, edge.from);
        const auto to = corner(placed_.clip, edge.to);
        const auto end_from = corner(ends_, edge.from);
        const auto end_to = corner(ends_, edge.to);
        visit(Polygon{to, from, end_from}, count, deep_);
        if (!ends_in_one_point_) visit(Polygon{to, end_from, end_to}, count, deep_);
    }

    static raster::ClipVertex<0> corner(const std::vector<glm::vec4>& positions,
                                        std::uint32_t vertex) {
        return {positions[vertex], {}};
    }
    Polygon polygon_of(std::size_t face, const std::vector<glm::vec4>& positions) const {
        Polygon corners;
        for (const std::uint32_t vertex : placed_.mesh->face(face))
            corners.push_back(corner(positions, vertex));
        return corners;
    }

    const PlacedMesh& placed_;
    std::vector<mesh::Facing> facing_;
    std::vector<mesh::SilhouetteEdge> silhouette_;
    std::vector<glm::vec4> ends_;  // where each vertex's shadow ends, clip space
    bool ends_in_one_point_;       // all of them
    std::int32_t orientation_;     // -1 where the placing mirrors
    raster::Deep deep_;            // the same for all faces, or the surface gaped
};

}  // namespace scanlight::render
