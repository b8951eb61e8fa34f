#pragma once

#include <optional>
#include <vector>

#include "apps/scene/models.h"
#include "apps/scene/scene_options.h"
#include "render/orbit.h"

namespace scanlight::apps {

/// Round what is to be seen.
struct Orbit {
    double angle_deg = 360.0;             // in all
    std::optional<double> elevation_deg;  // instead of the view's
};

/// Throws UsageError or FileError unless the camera's keys are in order of time and of one kind.
void check_camera_keys(const SceneOptions& options);

/// Where the camera is at each moment of a turntable: by the scene's camera keys, or in an orbit.
/// Where the camera is given by a side to look from, it stays at one distance, from which all can
/// be seen whatever the side.
class CameraPath {
public:
    CameraPath(const Models& models, const SceneOptions& options, const Orbit& orbit);

    /// The options of a picture at a time from 0 to 1.
    SceneOptions at(double time) const;

private:
    SceneOptions from_side(const render::ViewAngles& view) const;
    SceneOptions orbiting(double time) const;
    SceneOptions by_keys(double time) const;

    const SceneOptions& options_;
    Orbit orbit_;
    glm::dvec3 middle_;
    std::vector<render::Ring> rings_;  // of what is seen, about the middle
};

}  // namespace scanlight::apps
