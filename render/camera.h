#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace scanlight::render {

enum class Projection { perspective, orthographic };

/// Looks from `eye` to `target`. World space, right-handed; in eye space the camera sits at the
/// origin and looks down -z.
struct Camera {
    glm::dvec3 eye{0.0, 0.0, 5.0};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};  // any direction but the view's own; then another is taken
    Projection projection = Projection::perspective;
    /// Perspective: cot(fov_y / 2). Orthographic: 1 / half the picture's height in world units.
    double magnification = 2.4142135623730951;
    double near = 0.1;  // distances of the clip planes from the eye, along the view
    double far = 100.0;
};

/// Perspective magnification of a vertical field of view in degrees, in (0, 180).
double magnification_from_fov(double fov_deg);

/// Perspective magnification of a lens: focal length F and frame height h in the same unit give
/// fov_y = 2 atan(h / (2F)), so that cot(fov_y / 2) = 2F / h.
double magnification_from_lens(double focal_length, double frame_height);

glm::dmat4 eye_from_world(const Camera& camera);

/// Clip space of the rasterizer: -w <= x, y <= w and 0 <= z <= w, nearer is smaller. `aspect` is
/// width over height.
glm::dmat4 clip_from_eye(const Camera& camera, double aspect);

/// From where points are seen, homogeneous: the eye's place (w = 1), or for an orthographic camera
/// the direction towards it (w = 0).
glm::dvec4 viewpoint(const Camera& camera);

}  // namespace scanlight::render
