#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// Ideal diffuse reflection: Lambert 1760; Bouknight 1970, "A procedure for generation of
/// three-dimensional half-toned computer graphics presentations", CACM 13(9).
///     (L.N)+, to be multiplied by I_p K_d
/// Brightest where the light stands on the normal, 0 from 90 degrees on, the same for every eye.
template <class Real>
Real lambert(const Vec3<Real>& N, const Vec3<Real>& L) noexcept {
    return positive_part(dot(L, N));
}

}  // namespace scanlight::shading
