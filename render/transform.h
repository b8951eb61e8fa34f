#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "shading/vector.h"

namespace scanlight::render {

// A mesh on its way into the world and to the screen. Templates on the number type, as in
// shading/real.h: double for one vertex, a vector of lanes for many, of the same bits. The order of
// the operations is part of the contract.

/// One component of m (x, y, z, 1).
template <class Real, class Number>
Real point_component(const glm::mat<4, 4, Number>& m, int row, const shading::Vec3<Real>& p) {
    return (Real(m[0][row]) * p.x + Real(m[1][row]) * p.y) +
           (Real(m[2][row]) * p.z + Real(m[3][row]));
}

/// m (x, y, z, 1), homogeneous.
template <class Real, class Number>
glm::vec<4, Real> transformed_point(const glm::mat<4, 4, Number>& m, const shading::Vec3<Real>& p) {
    return {point_component(m, 0, p), point_component(m, 1, p), point_component(m, 2, p),
            point_component(m, 3, p)};
}

/// One component of m d.
template <class Real, class Number>
Real direction_component(const glm::mat<3, 3, Number>& m, int row, const shading::Vec3<Real>& d) {
    return (Real(m[0][row]) * d.x + Real(m[1][row]) * d.y) + Real(m[2][row]) * d.z;
}

/// A normal by the inverse transpose of the matrix that takes points: unit, or as it was where the
/// matrix leaves nothing of it.
template <class Real, class Number>
shading::Vec3<Real> transformed_normal(const glm::mat<3, 3, Number>& m,
                                       const shading::Vec3<Real>& normal) {
    const shading::Vec3<Real> turned(direction_component(m, 0, normal),
                                     direction_component(m, 1, normal),
                                     direction_component(m, 2, normal));
    return shading::unit_or(turned, normal);
}

}  // namespace scanlight::render
