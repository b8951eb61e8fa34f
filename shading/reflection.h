#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// The mirror image of `direction` about the normal N, both unit and pointing away from the
/// surface; the law of reflection: angle in = angle out, in one plane.
///     R = 2 N (N.L) - L
/// Of the direction to the light it is R, of the direction to the eye S. Where N.L < 0 the light
/// is behind the surface and R has no meaning.
template <class Real>
Vec3<Real> reflected(const Vec3<Real>& direction, const Vec3<Real>& normal) noexcept {
    return normal * (Real(2) * dot(normal, direction)) - direction;
}

}  // namespace scanlight::shading
