#include "apps/demo/window/light_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "apps/demo/window/round.h"

namespace scanlight::apps::window {

namespace {

constexpr double right_angle = std::numbers::pi / 2;

Point middle_of(const Box& box) {
    return {box.x + box.width / 2.0, box.y + box.height / 2.0};
}

// ---- directions

/// Towards a light at infinity; eye space, unit.
glm::dvec3 direction_seen(const LightOption& light, const render::Camera& camera) {
    const glm::dvec3 towards = glm::normalize(light.place);
    return light.frame == LightFrame::world ? glm::dmat3(render::eye_from_world(camera)) * towards
                                            : towards;
}

Point place_of(const glm::dvec3& direction, const Box& picture) {
    const double angle = std::acos(std::clamp(direction.z, -1.0, 1.0));
    const double across = std::hypot(direction.x, direction.y);
    const double share = across > 0.0 ? light_circle(picture) * angle / right_angle / across : 0.0;
    const Point middle = middle_of(picture);
    return {middle.x + share * direction.x, middle.y - share * direction.y};
}

/// Eye space, unit.
glm::dvec3 direction_at(Point at, const Box& picture) {
    const Point middle = middle_of(picture);
    const double x = at.x - middle.x;
    const double y = middle.y - at.y;
    const double across = std::hypot(x, y);
    if (!(across > 0.0)) return {0.0, 0.0, 1.0};
    const double angle = std::min(across / light_circle(picture), 2.0) * right_angle;
    return {std::sin(angle) * x / across, std::sin(angle) * y / across, std::cos(angle)};
}

glm::dvec3 in_frame(const glm::dvec3& direction_eye, LightFrame frame,
                    const render::Camera& camera) {
    if (frame == LightFrame::camera) return direction_eye;
    return glm::transpose(glm::dmat3(render::eye_from_world(camera))) * direction_eye;
}

// ---- lamps

glm::dmat4 clip_from_world(const render::Camera& camera, const Box& picture) {
    const double aspect = static_cast<double>(picture.width) / picture.height;
    return render::clip_from_eye(camera, aspect) * render::eye_from_world(camera);
}

std::optional<Point> place_of_lamp(const glm::dvec3& position, const render::Camera& camera,
                                   const Box& picture) {
    const glm::dvec4 clip = clip_from_world(camera, picture) * glm::dvec4(position, 1.0);
    if (!(clip.w > 0.0)) return std::nullopt;
    return Point{picture.x + (clip.x / clip.w + 1.0) / 2.0 * picture.width,
                 picture.y + (1.0 - clip.y / clip.w) / 2.0 * picture.height};
}

glm::dvec3 lamp_at(Point at, const glm::dvec3& before, const render::Camera& camera,
                   const Box& picture) {
    const glm::dmat4 to_clip = clip_from_world(camera, picture);
    const glm::dvec4 clip = to_clip * glm::dvec4(before, 1.0);
    const double x = 2.0 * (at.x - picture.x) / picture.width - 1.0;
    const double y = 1.0 - 2.0 * (at.y - picture.y) / picture.height;
    const glm::dvec4 world =
        glm::inverse(to_clip) * glm::dvec4(x * clip.w, y * clip.w, clip.z, clip.w);
    const glm::dvec3 place = glm::dvec3(world) / world.w;
    return rounded(place, std::max(glm::length(camera.eye - camera.target), 1e-12), 4);
}

}  // namespace

double light_circle(const Box& picture) {
    return 0.24 * std::min(picture.width, picture.height);
}

std::vector<LightHandle> light_handles(const SceneOptions& options, const render::Camera& camera,
                                       const Box& picture) {
    std::vector<LightHandle> handles;
    const auto lights = lights_in(options);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LightOption& light = lights[i];
        if (light.frame == LightFrame::point) {
            const auto place = place_of_lamp(light.place, camera, picture);
            if (place) handles.push_back({i, *place, false, light.color});
        } else {
            const glm::dvec3 direction = direction_seen(light, camera);
            handles.push_back({i, place_of(direction, picture), direction.z < 0.0, light.color});
        }
    }
    return handles;
}

SceneOptions with_light_at(SceneOptions options, std::size_t index, Point at,
                           const render::Camera& camera, const Box& picture) {
    options.lights = lights_in(options);
    LightOption& light = options.lights.at(index);
    light.place = light.frame == LightFrame::point
                      ? lamp_at(at, light.place, camera, picture)
                      : rounded(in_frame(direction_at(at, picture), light.frame, camera), 1.0, 4);
    return options;
}

SceneOptions with_more_light(SceneOptions options, const LightOption& light) {
    options.lights = lights_in(options);
    options.lights.push_back(light);
    return options;
}

SceneOptions with_less_light(SceneOptions options) {
    if (options.lights.size() > 1) options.lights.pop_back();
    return options;
}

}  // namespace scanlight::apps::window
