#pragma once

#include <span>
#include <vector>

#include "render/camera.h"
#include "render/scene.h"

namespace scanlight::render {

/// The camera's eye carried about its target, `angle_deg` counter-clockwise seen from the tip of
/// its up vector.
Camera orbited(Camera camera, double angle_deg);

/// The circle about the vertical through the camera's target on which an orbit sees a point.
struct Ring {
    double radius = 0.0;
    double height = 0.0;  // above the target
};

/// How far from its target a camera must stand at this elevation for the points of all rings to be
/// in the picture, from any side: the frames of an orbit do not grow and shrink.
double distance_for_orbit(const Camera& camera, std::span<const Ring> rings, double elevation_deg,
                          double aspect);

/// A smooth curve through values at times that grow: cubic Hermite pieces, whose slope at each
/// value is that between its neighbours (Catmull & Rom 1974, for uneven times). Before the first
/// time and after the last it stands still. `values` has one for each of `times`, at least one.
double smoothly(std::span<const double> times, std::span<const double> values, double time);

}  // namespace scanlight::render
