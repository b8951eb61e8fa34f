#include "apps/demo/window/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "apps/demo/window/round.h"
#include "apps/scene/scene_setup.h"

namespace scanlight::apps::window {

namespace {

constexpr double degrees_a_pixel = 0.4;
constexpr double highest_deg = 89.0;
constexpr double factor_a_notch = 1.1;
constexpr int digits = 5;

SceneOptions standing(SceneOptions options, const glm::dvec3& eye, const glm::dvec3& target) {
    const double size = std::max({glm::length(eye - target), glm::length(target), 1e-12});
    options.camera_keys.clear();
    options.eye = rounded(eye, size, digits);
    options.target = rounded(target, size, digits);
    return options;
}

/// How far from its target the eye has to stand for things to stay as large as they are: where
/// lines of sight are parallel, the field of view is that which a perspective camera would need.
double distance_of(const SceneOptions& options, const render::Camera& camera) {
    if (camera.projection == render::Projection::perspective)
        return glm::length(camera.eye - camera.target);
    return bare_camera(options).magnification * options.zoom / camera.magnification;
}

/// World units that a pixel shows at the target.
double pixel_size(const render::Camera& camera, int height) {
    const double distance = camera.projection == render::Projection::perspective
                                ? glm::length(camera.eye - camera.target)
                                : 1.0;
    return 2.0 * distance / (camera.magnification * height);
}

}  // namespace

render::ViewAngles angles_of(const glm::dvec3& direction) {
    constexpr double deg = 180.0 / std::numbers::pi;
    const glm::dvec3 d = glm::normalize(direction);
    return {std::atan2(d.x, d.z) * deg, std::asin(std::clamp(d.y, -1.0, 1.0)) * deg};
}

SceneOptions turned(SceneOptions options, const render::Camera& camera, Point by) {
    const glm::dvec3 arm = camera.eye - camera.target;
    render::ViewAngles angles = angles_of(arm);
    angles.azimuth_deg -= by.x * degrees_a_pixel;
    angles.elevation_deg =
        std::clamp(angles.elevation_deg + by.y * degrees_a_pixel, -highest_deg, highest_deg);
    const glm::dvec3 eye =
        camera.target + distance_of(options, camera) * render::direction_of(angles);
    return standing(std::move(options), eye, camera.target);
}

SceneOptions panned(SceneOptions options, const render::Camera& camera, Point by, int height) {
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(render::eye_from_world(camera)));
    const glm::dvec3 shift =
        world_from_eye * glm::dvec3(-by.x, by.y, 0.0) * pixel_size(camera, height);
    const glm::dvec3 target = camera.target + shift;
    const glm::dvec3 arm =
        distance_of(options, camera) * glm::normalize(camera.eye - camera.target);
    return standing(std::move(options), target + arm, target);
}

SceneOptions zoomed(SceneOptions options, double notches) {
    const double zoom = options.zoom * std::pow(factor_a_notch, notches);
    options.zoom = std::clamp(rounded(zoom, zoom, 4), 0.001, 1000.0);
    return options;
}

}  // namespace scanlight::apps::window
