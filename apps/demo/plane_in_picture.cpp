#include "apps/demo/plane_in_picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace scanlight::demo {

namespace {

/// Without z, which is 0 in the plane and does not matter in the picture.
glm::dmat3 flat(const glm::dmat4& clip_from_world) {
    const auto& m = clip_from_world;
    return {m[0].x, m[0].y, m[0].w, m[1].x, m[1].y, m[1].w, m[3].x, m[3].y, m[3].w};
}

}  // namespace

glm::dmat3 picture_from_plane(const render::Camera& camera, raster::Viewport size) {
    const double half_width = size.width / 2.0;
    const double half_height = size.height / 2.0;
    const glm::dmat4 clip_from_world =
        render::clip_from_eye(camera, half_width / half_height) * render::eye_from_world(camera);
    const glm::dmat3 picture_from_clip(half_width, 0.0, 0.0, 0.0, -half_height, 0.0, half_width,
                                       half_height, 1.0);
    return picture_from_clip * flat(clip_from_world);
}

glm::dvec2 mapped(const glm::dmat3& matrix, const glm::dvec2& point) {
    const glm::dvec3 p = matrix * glm::dvec3(point, 1.0);
    return glm::dvec2(p) / p.z;
}

}  // namespace scanlight::demo
