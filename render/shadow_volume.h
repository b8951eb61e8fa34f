#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "mesh/silhouette.h"
#include "raster/clip_volume.h"
#include "render/frame.h"

namespace scanlight::render {

/// Whether an object keeps light away. What lets light through, under a model that knows of it,
/// does not: neither from other objects nor from its own far side.
bool casts_shadow(const Object& object, const Settings& settings);

/// How a surface goes on beyond the far plane so that depth can tell its ends; `beyond_far` says
/// whether any vertex lies there.
raster::Deep deep_for(const Frame& frame, bool beyond_far);

/// The shadow volumes of all faces of an object together: a closed surface round the points that
/// the object hides from a light (Crow 1977, "Shadow algorithms for computer graphics", SIGGRAPH).
/// It begins with a cap, the faces themselves, all turned to the light; sides go from the edges
/// that are left over (see `mesh::SilhouetteFinder`) away from the light to infinity, where the
/// faces stand once more and close it. Points at infinity are homogeneous points with w = 0.
class ShadowVolume {
public:
    ShadowVolume(const Object& object, const mesh::SilhouetteFinder& finder,
                 const glm::dvec4& light, const Frame& frame);

    /// Calls `visit(corners, count, at_end, face)` with the faces of both caps, in clip space.
    /// Counter-clockwise corners show the outside; `count` is how often a face is there, less than
    /// 0 where its inside is shown. Those at the end lie behind everything.
    template <class Visit>
    void for_each_cap(Visit&& visit) const {
        for (std::size_t f = 0; f < silhouette_.facing.size(); ++f) {
            const auto facing = static_cast<std::int32_t>(silhouette_.facing[f]);
            if (facing == 0) continue;
            visit(cap(f), orientation_ * facing, false, f);
            if (!ends_in_one_point_) visit(end_cap(f), -orientation_ * facing, true, f);
        }
    }

    /// Whether a face of the caps may go through the near plane.
    bool has_cap_through_near() const;

    /// The sides have three or four corners: calls `visit(corners, count, edge)`.
    template <class Visit>
    void for_each_side(Visit&& visit) const {
        for (const mesh::SilhouetteEdge& edge : silhouette_.edges)
            visit(side(edge), orientation_ * edge.multiplicity, edge);
    }

private:
    using Polygon = raster::BareClipPolygon;

    Polygon cap(std::size_t face) const;
    Polygon end_cap(std::size_t face) const;
    Polygon side(const mesh::SilhouetteEdge& edge) const;
    raster::ClipVertex<0> corner(std::uint32_t vertex) const;
    raster::ClipVertex<0> end(std::uint32_t vertex) const;
    glm::vec4 corner_at(const glm::dvec3& position) const;
    glm::vec4 end_at(const glm::dvec3& position) const;

    const mesh::Mesh& mesh_;
    glm::dmat4 world_from_object_;
    glm::dmat4 clip_from_world_;
    glm::dmat4 clip_from_object_;
    glm::dvec4 light_;
    double w_of_ends_;
    bool ends_in_one_point_;    // all shadows
    std::int32_t orientation_;  // -1 where the placing mirrors
    mesh::Box bounds_;          // of the mesh
    mesh::Silhouette silhouette_;
};

}  // namespace scanlight::render
