#include "render/surroundings.h"

namespace scanlight::render {

namespace {

/// Along the line of sight, away from the eye: unit, world space.
glm::vec3 sight(const Frame& frame, int x, int y) {
    const glm::mat4& m = frame.world_from_screen;
    const glm::vec3 screen(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0.5f);
    const glm::vec3 point = point_behind(m, screen);
    const float w = point_component(m, 3, screen);
    const glm::vec3 deeper((m[2].x - point.x * m[2].w) / w, (m[2].y - point.y * m[2].w) / w,
                           (m[2].z - point.z * m[2].w) / w);
    return shading::unit_or(deeper, glm::vec3(0.0f, 0.0f, -1.0f));
}

}  // namespace

raster::Rgba surroundings_at(const Frame& frame, int x, int y) {
    return raster::Rgba(shading::light_from(*frame.surroundings, sight(frame, x, y)), 1.0f);
}

}  // namespace scanlight::render
