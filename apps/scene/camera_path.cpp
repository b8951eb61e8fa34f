#include "apps/scene/camera_path.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "apps/scene/placement.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/usage_error.h"
#include "mesh/file_error.h"
#include "render/framing.h"

namespace scanlight::apps {

namespace {

/// A part of the keys that is interpolated: what `part(key)` says, or `otherwise` where it says
/// nothing.
template <class Part>
double interpolated(const std::vector<CameraKey>& keys, double time, double otherwise, Part part) {
    std::vector<double> times;
    std::vector<double> values;
    for (const CameraKey& key : keys) {
        times.push_back(key.at);
        const std::optional<double> value = part(key);
        values.push_back(value.value_or(otherwise));
    }
    return render::smoothly(times, values, time);
}

glm::dvec3 interpolated_point(const std::vector<CameraKey>& keys, double time,
                              const glm::dvec3& otherwise,
                              std::optional<glm::dvec3> CameraKey::*point) {
    glm::dvec3 result;
    for (int k = 0; k < 3; ++k) {
        result[k] = interpolated(keys, time, otherwise[k], [&](const CameraKey& key) {
            return key.*point ? std::optional((*(key.*point))[k]) : std::nullopt;
        });
    }
    return result;
}

render::ViewAngles interpolated_view(const std::vector<CameraKey>& keys, double time) {
    const auto azimuth = [](const CameraKey& key) { return std::optional(key.view->azimuth_deg); };
    const auto elevation = [](const CameraKey& key) {
        return std::optional(key.view->elevation_deg);
    };
    return {interpolated(keys, time, 0.0, azimuth),
            std::clamp(interpolated(keys, time, 0.0, elevation), -90.0, 90.0)};
}

void add_rings(const mesh::Vertices& vertices, const glm::dmat4& world_from_object,
               const glm::dvec3& middle, std::vector<render::Ring>& rings) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 point(world_from_object *
                               glm::dvec4(glm::dvec3(vertices.position(i)), 1.0));
        const glm::dvec3 arm = point - middle;
        rings.push_back({std::sqrt(arm.x * arm.x + arm.z * arm.z), arm.y});
    }
}

}  // namespace

void check_camera_keys(const SceneOptions& options) {
    const auto& keys = options.camera_keys;
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].at <= keys[i - 1].at)
            throw mesh::FileError(keys[i].stated.at({"at"}) +
                                  ": [[camera.key]] is not later than the one before");
        if (keys[i].eye.has_value() != keys[0].eye.has_value())
            throw mesh::FileError(keys[i].stated.at({"view", "eye"}) +
                                  ": [[camera.key]] with 'view' among others with 'eye'");
    }
}

CameraPath::CameraPath(const Models& models, const SceneOptions& options, const Orbit& orbit)
    : options_(options), orbit_(orbit), middle_(models.box.center()) {
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        add_rings(models.of_object[i]->mesh.vertices, matrix_of(options.objects[i].placement),
                  middle_, rings_);
    }
}

SceneOptions CameraPath::at(double time) const {
    return options_.camera_keys.empty() ? orbiting(time) : by_keys(time);
}

/// At one distance for all sides.
SceneOptions CameraPath::from_side(const render::ViewAngles& view) const {
    SceneOptions options = options_;
    const double aspect = static_cast<double>(options.size.width) / options.size.height;
    const double distance =
        render::distance_for_orbit(bare_camera(options), rings_, view.elevation_deg, aspect);
    options.target = middle_;
    options.eye = middle_ + std::max(distance, 1e-30) * render::direction_of(view);
    return options;
}

SceneOptions CameraPath::orbiting(double time) const {
    const double turned = time * orbit_.angle_deg;
    if (!options_.eye) {
        render::ViewAngles view = options_.view;
        view.azimuth_deg += turned;
        view.elevation_deg = orbit_.elevation_deg.value_or(view.elevation_deg);
        return from_side(view);
    }
    if (orbit_.elevation_deg) throw UsageError("--elevation-deg with an eye; expected one of them");
    SceneOptions options = options_;
    render::Camera camera = bare_camera(options);
    camera.eye = *options.eye;
    camera.target = options.target.value_or(middle_);
    camera = render::orbited(camera, turned);
    options.eye = camera.eye;
    options.target = camera.target;
    return options;
}

SceneOptions CameraPath::by_keys(double time) const {
    const auto& keys = options_.camera_keys;
    SceneOptions options = options_;
    if (keys.front().view) {
        options = from_side(interpolated_view(keys, time));
    } else {
        options.eye = interpolated_point(keys, time, {}, &CameraKey::eye);
        options.target =
            interpolated_point(keys, time, options_.target.value_or(middle_), &CameraKey::target);
    }
    options.zoom = std::clamp(
        interpolated(keys, time, options_.zoom, [](const CameraKey& key) { return key.zoom; }),
        0.001, 1000.0);
    const bool has_angles =
        std::ranges::any_of(keys, [](const CameraKey& key) { return key.fov_deg.has_value(); });
    if (has_angles) {
        const double fov = interpolated(keys, time, options_.fov_deg,
                                        [](const CameraKey& key) { return key.fov_deg; });
        set_field_of_view(options, std::clamp(fov, 1.0, 170.0));
    }
    return options;
}

}  // namespace scanlight::apps
