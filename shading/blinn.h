#pragma once

#include "shading/power.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// H = (L + V)/|L + V|: the normal of a mirror that would send L to V. Zero, and so without a
/// highlight, where the light stands straight behind the point as seen by the eye, L = -V.
template <class Real>
Vec3<Real> half_vector(const Vec3<Real>& L, const Vec3<Real>& V) noexcept {
    return unit_or(L + V, Vec3<Real>(Real(0)));
}

/// The highlight of Blinn 1977, "Models of light reflection for computer synthesized pictures",
/// SIGGRAPH.
///     ((N.H)+)^n, to be multiplied by I_p K_s
/// Unit vectors pointing away from the surface. 0 where N.L <= 0. In the plane of N, L and V the
/// angle between N and H is half of that between R and V, so the highlight is as wide as Phong's
/// with 4n. H is an argument because light and eye at infinity have but one.
template <class Real, class Power>
Real blinn(const Vec3<Real>& N, const Vec3<Real>& L, const Vec3<Real>& H, const Power& n) noexcept {
    const auto is_lit = dot(L, N) > Real(0);
    if (none(is_lit)) return Real(0);
    return select(is_lit, power(positive_part(dot(N, H)), n), Real(0));
}

}  // namespace scanlight::shading
