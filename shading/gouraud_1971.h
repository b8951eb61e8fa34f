#pragma once

#include <limits>

#include "shading/lambert.h"

namespace scanlight::shading {

/// The intensity of Gouraud 1971, "Continuous shading of curved surfaces", IEEE Transactions on
/// Computers C-20(6): diffuse only.
///     (L.N)+ / (r + k), to be multiplied by I_p K_d
/// r is the distance to the light; give the distance to the eye instead for the textbooks that mean
/// that one. k > 0, in world units, keeps the value finite at r = 0. A light at infinity (r
/// infinite) would be lost in the quotient: nothing is divided, and Lambert's term remains.
template <class Real>
Real gouraud_1971(const Vec3<Real>& N, const Vec3<Real>& L, Real r, Real k) noexcept {
    const Real infinity(std::numeric_limits<float>::infinity());
    const Real diffuse = lambert(N, L);
    return select(r < infinity, diffuse / (r + k), diffuse);
}

}  // namespace scanlight::shading
