#pragma once

#include <glm/vec3.hpp>

#include "raster/project.h"
#include "render/camera.h"

namespace scanlight::same_bits {

/// Depths that the camera below sees, larger is nearer.
inline constexpr double lowest_z = -7.0;
inline constexpr double highest_z = 9.0;

/// An orthographic camera that shows the point (x, -y, z) of the world x pixels from the left and y
/// from the top.
inline render::Camera pixel_camera(raster::Viewport size) {
    render::Camera camera;
    camera.target = {0.5 * size.width, -0.5 * size.height, 0.0};
    camera.eye = camera.target + glm::dvec3(0.0, 0.0, highest_z + 1.0);
    camera.projection = render::Projection::orthographic;
    camera.magnification = 2.0 / size.height;
    camera.near = 1.0;
    camera.far = 1.0 + highest_z - lowest_z;
    return camera;
}

inline glm::vec3 at_pixel(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(-y), static_cast<float>(z)};
}

}  // namespace scanlight::same_bits
