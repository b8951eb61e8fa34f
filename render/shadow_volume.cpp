#include "render/shadow_volume.h"

#include <algorithm>

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

/// Away from the light, as far as it goes.
std::vector<glm::vec4> ends_of(const Object& object, const glm::dvec4& light, const Frame& frame) {
    const mesh::Vertices& vertices = object.mesh->vertices;
    const double w = w_of_ends(frame);
    std::vector<glm::vec4> result;
    result.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 point(
            transformed_point(object.world_from_object, glm::dvec3(vertices.position(i))));
        const glm::dvec3 away = light.w * point - glm::dvec3(light);
        result.emplace_back(frame.clip_from_world * glm::dvec4(away + w * point, w));
    }
    return result;
}

bool is_beyond_far(const glm::vec4& position) {
    return raster::distance(position, raster::ClipPlane::far) < 0.0f;
}

/// Points at infinity have a depth that the format can tell.
bool tells_infinity(const Frame& frame) {
    // z = a w + b in perspective, which is a w at infinity.
    const glm::dvec4 z_row = glm::row(frame.clip_from_world, 2);
    const glm::dvec4 w_row = glm::row(frame.clip_from_world, 3);
    const double z = glm::dot(glm::dvec3(z_row), glm::dvec3(w_row));
    const double w = glm::dot(glm::dvec3(w_row), glm::dvec3(w_row));
    return !frame.is_parallel() && z < raster::deepest_ndc * w;
}

}  // namespace

glm::dvec4 homogeneous(const shading::Light<float>& light) {
    const bool has_place = light.kind == shading::Light<float>::Kind::point;
    return {glm::dvec3(light.place), has_place ? 1.0 : 0.0};
}

ShadowVolume::ShadowVolume(const Object& object, const PlacedMesh& placed, const mesh::Edges& edges,
                           const glm::dvec4& light, const Frame& frame)
    : placed_(placed),
      facing_(mesh::facing(*object.mesh, glm::inverse(object.world_from_object) * light)),
      silhouette_(mesh::silhouette(edges, facing_)),
      ends_(ends_of(object, light, frame)),
      ends_in_one_point_(light.w == 0.0 && !frame.is_parallel()),
      orientation_(placed.mirrored ? -1 : 1),
      deep_(tells_infinity(frame) && std::ranges::none_of(placed.clip, is_beyond_far)
                ? raster::Deep::reaches
                : raster::Deep::splits) {}

}  // namespace scanlight::render
