#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/camera.h"
#include "render/scene.h"

namespace scanlight::render {

/// A light for geometry, world space, homogeneous: its place (w = 1), or the direction towards it
/// (w = 0).
glm::dvec4 homogeneous(const shading::Light<float>& light);

/// Cameras of square pictures by which a light sees all objects. A directional light has one, of
/// parallel rays; a point light six that look along the axes of the world (+x, -x, +y, -y, +z, -z),
/// each over 90 degrees, since it may stand amid the scene.
std::vector<Camera> light_cameras(const glm::dvec4& light, const std::vector<Object>& objects);

/// Which of a point light's six cameras sees what lies in a direction from it.
std::size_t cube_face(const glm::dvec3& from_light);

/// A camera's square picture without pixels.
class LightView {
public:
    explicit LightView(const Camera& camera);

    /// A point as the camera sees it: x to the right and y up, each from -1 to 1 in the picture,
    /// and its distance along the view, in world units. Perspective: of a point before the camera.
    glm::dvec3 seen(const glm::dvec3& point) const;

    /// Half the picture's width in world units, at a distance along the view.
    double half_width(double distance) const {
        return (is_parallel() ? 1.0 : distance) / camera_.magnification;
    }

    /// In eye space the camera looks along -z.
    glm::dvec3 in_eye_space(const glm::dvec3& point) const;
    /// The ray, world space, of all points that are seen at (x, y).
    struct Ray {
        glm::dvec3 origin, direction;
    };
    Ray ray(double x, double y) const;

    bool is_parallel() const { return camera_.projection == Projection::orthographic; }
    const Camera& camera() const { return camera_; }

private:
    Camera camera_;
    glm::dmat4 eye_from_world_;
};

}  // namespace scanlight::render
