#include "render/shadow_volume.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "render/transform.h"

namespace scanlight::render {

namespace {

/// The w of points at infinity. Parallel lines of sight all end in one point there, in which
/// nothing can be told apart: then shadows end a million times as far away as the light.
double w_of_ends(const Frame& frame) {
    return frame.is_parallel() ? 0x1p-20 : 0.0;
}

/// Points at infinity have a depth that the format can tell.
bool tells_infinity(const Frame& frame) {
    // z = a w + b in perspective, which is a w at infinity.
    const glm::dvec3 z_row(glm::row(frame.clip_from_world, 2));
    const glm::dvec3 w_row(glm::row(frame.clip_from_world, 3));
    return !frame.is_parallel() &&
           glm::dot(z_row, w_row) < raster::deepest_ndc * glm::dot(w_row, w_row);
}

/// On which sides of the near plane some points lie; within a rounding of it, on both.
struct NearSides {
    bool inside = false;
    bool outside = false;

    void add(const glm::vec4& p) {
        const float rounding = 1e-5f * (std::abs(p.x) + std::abs(p.y) + std::abs(p.w));
        const float distance = raster::distance(p, raster::ClipPlane::near);
        inside = inside || distance >= -rounding;
        outside = outside || distance <= rounding;
    }
    bool both() const { return inside && outside; }
};

}  // namespace

bool casts_shadow(const Object& object, const Settings& settings) {
    if (settings.illumination != shading::Illumination::hall) return true;
    return std::ranges::all_of(object.materials,
                               [](const auto& m) { return shading::is_opaque(m.transmission); });
}

raster::Deep deep_for(const Frame& frame, bool beyond_far) {
    return tells_infinity(frame) && !beyond_far ? raster::Deep::reaches : raster::Deep::splits;
}

ShadowVolume::ShadowVolume(const Object& object, const mesh::SilhouetteFinder& finder,
                           const glm::dvec4& light, const Frame& frame)
    : mesh_(*object.mesh),
      world_from_object_(object.world_from_object),
      clip_from_world_(frame.clip_from_world),
      clip_from_object_(frame.clip_from_world * object.world_from_object),
      light_(light),
      w_of_ends_(w_of_ends(frame)),
      ends_in_one_point_(light.w == 0.0 && w_of_ends_ == 0.0),
      orientation_(glm::determinant(glm::dmat3(object.world_from_object)) < 0.0 ? -1 : 1),
      bounds_(finder.bounds()),
      silhouette_(finder.from(glm::inverse(object.world_from_object) * light)) {}

/// Distances from a plane are linear, so extreme in the corners of the mesh's box; up to a
/// rounding.
bool ShadowVolume::has_cap_through_near() const {
    if (bounds_.empty()) return false;
    NearSides caps;
    NearSides ends;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 position((i & 1) != 0 ? bounds_.high.x : bounds_.low.x,
                                  (i & 2) != 0 ? bounds_.high.y : bounds_.low.y,
                                  (i & 4) != 0 ? bounds_.high.z : bounds_.low.z);
        caps.add(corner_at(position));
        ends.add(end_at(position));
    }
    return caps.both() || (!ends_in_one_point_ && ends.both());
}

ShadowVolume::Polygon ShadowVolume::cap(std::size_t face) const {
    Polygon corners;
    for (const std::uint32_t vertex : mesh_.face(face))
        corners.push_back(corner(vertex));
    return corners;
}

ShadowVolume::Polygon ShadowVolume::end_cap(std::size_t face) const {
    Polygon corners;
    for (const std::uint32_t vertex : mesh_.face(face))
        corners.push_back(end(vertex));
    return corners;
}

ShadowVolume::Polygon ShadowVolume::side(const mesh::SilhouetteEdge& edge) const {
    Polygon corners{corner(edge.to), corner(edge.from), end(edge.from)};
    if (!ends_in_one_point_) corners.push_back(end(edge.to));
    return corners;
}

raster::ClipVertex<0> ShadowVolume::corner(std::uint32_t vertex) const {
    return {corner_at(glm::dvec3(mesh_.vertices.position(vertex))), {}};
}

raster::ClipVertex<0> ShadowVolume::end(std::uint32_t vertex) const {
    return {end_at(glm::dvec3(mesh_.vertices.position(vertex))), {}};
}

/// By the steps of all vertices, so that a cap lies where its faces are drawn, to the bit.
glm::vec4 ShadowVolume::corner_at(const glm::dvec3& position) const {
    return glm::vec4(transformed_point(clip_from_object_, position));
}

/// Away from the light, as far as it goes.
glm::vec4 ShadowVolume::end_at(const glm::dvec3& position) const {
    const glm::dvec3 point(transformed_point(world_from_object_, position));
    const glm::dvec3 away = light_.w * point - glm::dvec3(light_);
    return glm::vec4(clip_from_world_ * glm::dvec4(away + w_of_ends_ * point, w_of_ends_));
}

}  // namespace scanlight::render
