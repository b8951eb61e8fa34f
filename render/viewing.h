#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/transform.h"
#include "shading/vector.h"

namespace scanlight::render {

// From a pixel back into the world. Templates on the number type, as in shading/real.h.

/// V: unit, from a point in world space towards the eye. `viewpoint` is homogeneous: the eye, or
/// the direction to it.
template <class Real>
shading::Vec3<Real> view_from(const glm::vec4& viewpoint, const shading::Vec3<Real>& point) {
    const shading::Vec3<Real> towards_eye(Real(viewpoint.x) - point.x * Real(viewpoint.w),
                                          Real(viewpoint.y) - point.y * Real(viewpoint.w),
                                          Real(viewpoint.z) - point.z * Real(viewpoint.w));
    return shading::unit_or(towards_eye, shading::Vec3<Real>(Real(0), Real(0), Real(1)));
}

/// The lines along which pixels are seen: from the place (x, y) of the screen, in pixels, towards
/// the eye along origin + x right + y down, world space; from 2^-60 to 2^60 long, for any camera
/// whose picture is less than 2^119 times as wide as it is far away. All that may show there lies
/// on the line, so that no depth is asked for.
struct SightLines {
    glm::vec3 origin, right, down;
};

/// Those through one row of pixels: x pixels along it, towards start + x right.
struct SightRow {
    glm::vec3 start, right;
};

/// V: unit, towards the eye from what shows x pixels along the row.
template <class Real>
shading::Vec3<Real> view_along(const SightRow& row, Real x) {
    const auto part = [&](int i) { return Real(row.start[i]) + Real(row.right[i]) * x; };
    return shading::unit(shading::Vec3<Real>(part(0), part(1), part(2)));
}

/// The point in world space behind a place on the screen: x and y in pixels, depth 0 to 1. One
/// division: other bits than three.
template <class Real>
shading::Vec3<Real> point_behind(const glm::mat4& world_from_screen,
                                 const shading::Vec3<Real>& screen) {
    const auto p = transformed_point(world_from_screen, screen);
    const Real inverse_w = Real(1) / p.w;
    return {p.x * inverse_w, p.y * inverse_w, p.z * inverse_w};
}

}  // namespace scanlight::render
