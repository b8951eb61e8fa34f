#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/scene.h"

namespace scanlight::render {

/// From which side to look: azimuth about the y axis (0 looks from +z, 90 from +x), elevation
/// above the horizon, in degrees.
struct ViewAngles {
    double azimuth_deg = 30.0;
    double elevation_deg = 20.0;
};

/// Unit vector from the target towards the eye.
glm::dvec3 direction_of(const ViewAngles& angles);

/// Moves the camera along its view until the objects just fill the picture, and lays the near and
/// far planes round them. Keeps the direction, the field of view and the projection. With nothing
/// to see the camera stays as it is.
Camera framed(Camera camera, const std::vector<Object>& objects, double aspect);

/// Lays the near and far planes round the objects and leaves the rest: for a camera that was given.
/// Objects behind the eye are left out; near is at least far / 10000, so that depth keeps its bits.
Camera with_fitted_planes(Camera camera, const std::vector<Object>& objects);

/// With a near plane so near that depth can tell where shadows end, at infinity: else shadow
/// volumes have to be cut at the far plane, which takes longer. Perspective only.
Camera with_room_for_shadows(Camera camera);

}  // namespace scanlight::render
