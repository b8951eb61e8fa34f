#include "render/frame.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace scanlight::render {

namespace {

using Light = shading::Light<float>;

glm::dmat4 ndc_from_screen(raster::Viewport viewport) {
    glm::dmat4 m(1.0);
    m[0][0] = 2.0 / viewport.width;
    m[1][1] = -2.0 / viewport.height;
    m[3] = glm::dvec4(-1.0, 1.0, 0.0, 1.0);
    return m;
}

SightLines parallel_lines(const glm::dmat3& world_from_eye) {
    return {glm::vec3(world_from_eye[2]), glm::vec3(0.0f), glm::vec3(0.0f)};
}

/// Through the eye: 1 long along the view and longer beside it; then all by one factor, lest the
/// square of the longest overflow.
SightLines lines_through_eye(const glm::dmat3& world_from_eye, double magnification,
                             raster::Viewport viewport) {
    const double half_height = 1.0 / magnification;
    const double pixel = 2.0 * half_height / viewport.height;
    const glm::dvec3 corner =
        world_from_eye * glm::dvec3(0.5 * pixel * viewport.width, -half_height, 1.0);
    const double scale = 1.0 / std::sqrt(glm::length(corner));
    return {glm::vec3(corner * scale), glm::vec3(world_from_eye[0] * (-pixel * scale)),
            glm::vec3(world_from_eye[1] * (pixel * scale))};
}

SightLines sight_lines(const Camera& camera, Distances distances, raster::Viewport viewport) {
    const auto world_from_eye = glm::transpose(glm::dmat3(eye_from_world(camera)));
    return distances == Distances::infinite || camera.projection == Projection::orthographic
               ? parallel_lines(world_from_eye)
               : lines_through_eye(world_from_eye, camera.magnification, viewport);
}

Light at_infinity(const Light& light, const glm::vec3& target) {
    if (light.kind == Light::Kind::directional) return light;
    return shading::directional_light(light.place - target, light.intensity);
}

shading::Lighting<float> lights_at_infinity(shading::Lighting<float> lighting,
                                            const glm::vec3& target) {
    for (Light& light : lighting.lights)
        light = at_infinity(light, target);
    return lighting;
}

}  // namespace

SightRow Frame::sight_row(int y) const {
    const float to_centre = static_cast<float>(y) + 0.5f;
    return {sight_lines.origin + sight_lines.down * to_centre, sight_lines.right};
}

Frame frame_of(const Scene& scene, Distances distances, raster::Viewport viewport) {
    const Camera& camera = scene.camera;
    const double aspect = static_cast<double>(viewport.width) / viewport.height;
    const glm::dmat4 clip_from_world = clip_from_eye(camera, aspect) * eye_from_world(camera);
    Frame frame{viewport,
                clip_from_world,
                glm::mat4(glm::inverse(clip_from_world) * ndc_from_screen(viewport)),
                glm::vec4(viewpoint(camera)),
                sight_lines(camera, distances, viewport),
                scene.lighting,
                scene.mirrored.get(),
                scene.diffuse.get(),
                scene.surroundings.get()};
    if (distances == Distances::infinite) {
        frame.viewpoint = glm::vec4(glm::vec3(camera.eye - camera.target), 0.0f);
        frame.lighting = lights_at_infinity(scene.lighting, glm::vec3(camera.target));
    }
    return frame;
}

}  // namespace scanlight::render
