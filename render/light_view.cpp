#include "render/light_view.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/framing.h"

namespace scanlight::render {

namespace {

Camera camera_along(const glm::dvec3& place, int axis, double sign) {
    Camera camera;
    camera.eye = place;
    camera.target = place;
    camera.target[axis] += sign;
    camera.up = axis == 1 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    camera.magnification = 1.0;
    return camera;
}

}  // namespace

glm::dvec4 homogeneous(const shading::Light<float>& light) {
    const bool has_place = light.kind == shading::Light<float>::Kind::point;
    return {glm::dvec3(light.place), has_place ? 1.0 : 0.0};
}

std::vector<Camera> light_cameras(const glm::dvec4& light, const std::vector<Object>& objects) {
    std::vector<Camera> cameras;
    if (light.w == 0.0) {
        Camera camera;
        camera.eye = glm::dvec3(light);
        camera.target = glm::dvec3(0.0);
        camera.projection = Projection::orthographic;
        cameras.push_back(framed(camera, objects, 1.0));
    } else {
        for (const int axis : {0, 1, 2}) {
            for (const double sign : {1.0, -1.0}) {
                const Camera camera = camera_along(glm::dvec3(light), axis, sign);
                cameras.push_back(with_fitted_planes(camera, objects));
            }
        }
    }
    return cameras;
}

std::size_t cube_face(const glm::dvec3& from_light) {
    const glm::dvec3 size = glm::abs(from_light);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (from_light[axis] < 0.0 ? 1 : 0));
}

LightView::LightView(const Camera& camera)
    : camera_(camera), eye_from_world_(render::eye_from_world(camera)) {}

glm::dvec3 LightView::in_eye_space(const glm::dvec3& point) const {
    return glm::dvec3(eye_from_world_ * glm::dvec4(point, 1.0));
}

glm::dvec3 LightView::seen(const glm::dvec3& point) const {
    const glm::dvec3 p = in_eye_space(point);
    const double half = half_width(-p.z);
    return {p.x / half, p.y / half, -p.z};
}

LightView::Ray LightView::ray(double x, double y) const {
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(eye_from_world_));
    const double half = half_width(1.0);
    const glm::dvec3 beside(x * half, y * half, 0.0);
    const glm::dvec3 ahead(0.0, 0.0, -1.0);
    if (is_parallel()) return {camera_.eye + world_from_eye * beside, world_from_eye * ahead};
    return {camera_.eye, world_from_eye * (beside + ahead)};
}

}  // namespace scanlight::render
