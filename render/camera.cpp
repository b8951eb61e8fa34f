#include "render/camera.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/trigonometry.h"

namespace scanlight::render {

namespace {

glm::dvec3 unit(const glm::dvec3& v) {
    return v / std::sqrt(glm::dot(v, v));
}

glm::dvec3 view_axis(const Camera& camera) {
    const glm::dvec3 backwards = camera.eye - camera.target;
    return glm::dot(backwards, backwards) > 0.0 ? unit(backwards) : glm::dvec3(0.0, 0.0, 1.0);
}

/// The axis least aligned with `direction`.
glm::dvec3 another_up(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    if (size.x <= size.y && size.x <= size.z) return {1.0, 0.0, 0.0};
    return size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
}

glm::dvec3 right_axis(const Camera& camera, const glm::dvec3& backwards) {
    const glm::dvec3 right = glm::cross(camera.up, backwards);
    constexpr double parallel = 1e-12;
    const double size = glm::dot(right, right);
    if (size > parallel * glm::dot(camera.up, camera.up)) return right / std::sqrt(size);
    return unit(glm::cross(another_up(backwards), backwards));
}

}  // namespace

double magnification_from_fov(double fov_deg) {
    return 1.0 / mesh::tangent(fov_deg * mesh::pi / 360.0);
}

double magnification_from_lens(double focal_length, double frame_height) {
    return 2.0 * focal_length / frame_height;
}

glm::dmat4 eye_from_world(const Camera& camera) {
    const glm::dvec3 z = view_axis(camera);
    const glm::dvec3 x = right_axis(camera, z);
    const glm::dvec3 y = glm::cross(z, x);
    return {glm::dvec4(x.x, y.x, z.x, 0.0), glm::dvec4(x.y, y.y, z.y, 0.0),
            glm::dvec4(x.z, y.z, z.z, 0.0),
            glm::dvec4(-glm::dot(x, camera.eye), -glm::dot(y, camera.eye), -glm::dot(z, camera.eye),
                       1.0)};
}

glm::dmat4 clip_from_eye(const Camera& camera, double aspect) {
    const double n = camera.near;
    const double f = camera.far;
    const double m = camera.magnification;
    const bool perspective = camera.projection == Projection::perspective;
    glm::dmat4 clip(0.0);
    clip[0][0] = m / aspect;
    clip[1][1] = m;
    clip[2][2] = (perspective ? f : 1.0) / (n - f);
    clip[3][2] = (perspective ? f * n : n) / (n - f);
    clip[2][3] = perspective ? -1.0 : 0.0;
    clip[3][3] = perspective ? 0.0 : 1.0;
    return clip;
}

glm::dvec4 viewpoint(const Camera& camera) {
    return camera.projection == Projection::perspective ? glm::dvec4(camera.eye, 1.0)
                                                        : glm::dvec4(view_axis(camera), 0.0);
}

}  // namespace scanlight::render
