#pragma once

#include "shading/power.h"
#include "shading/reflection.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// How light falls on a surface, and how what it mirrors is seen: cosines.
template <class Real>
struct PhongAngles {
    Real LN, RV;
};

template <class Real>
PhongAngles<Real> phong_angles(const Vec3<Real>& N, const Vec3<Real>& L,
                               const Vec3<Real>& V) noexcept {
    return {dot(L, N), dot(reflected(L, N), V)};
}

template <class Real, class Power>
Real phong(const PhongAngles<Real>& angles, const Power& n) noexcept {
    const auto is_lit = angles.LN > Real(0);
    if (none(is_lit)) return Real(0);
    return select(is_lit, power(positive_part(angles.RV), n), Real(0));
}

/// The highlight of Bui-Tuong Phong 1975, "Illumination for computer generated pictures",
/// CACM 18(6).
///     ((R.V)+)^n, to be multiplied by I_p K_s
/// Unit vectors pointing away from the surface. 0 where N.L <= 0: a light behind the surface leaves
/// no highlight on it.
template <class Real, class Power>
Real phong(const Vec3<Real>& N, const Vec3<Real>& L, const Vec3<Real>& V, const Power& n) noexcept {
    return phong(phong_angles(N, L, V), n);
}

}  // namespace scanlight::shading
