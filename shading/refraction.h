#pragma once

#include <optional>

#include "shading/vector.h"

namespace scanlight::shading {

/// The law of refraction (Snell), from medium 1 into medium 2:
///     eta_1 sin(theta) = eta_2 sin(phi)
/// `cos_theta` is the cosine of the angle between the normal and the incident direction, 0 to 1;
/// the indices are positive. Returns cos(phi), or nothing at total internal reflection, where
/// eta_1 sin(theta) > eta_2. The sine is never taken of an angle: sin^2 = 1 - cos^2.
template <class Real>
std::optional<Real> refracted_cosine(Real eta_1, Real eta_2, Real cos_theta) noexcept {
    const Real eta = eta_1 / eta_2;
    const Real sin2_phi = (eta * eta) * (Real(1) - cos_theta * cos_theta);
    if (sin2_phi > Real(1)) return std::nullopt;
    return square_root(Real(1) - sin2_phi);
}

// The direction T of the refracted light, or of what is seen through the surface in the direction
// V. N and V are unit vectors on one side, in medium 1, N.V > 0; eta = eta_2/eta_1. (Some texts
// print the reciprocal, for which the same formulas bend light the wrong way.)

/// T of Heckbert, in Glassner (ed.), "An Introduction to Ray Tracing", 1989:
///     T = -V/eta - (cos(theta_2) - cos(theta_1)/eta) N
///     cos(theta_2) = sqrt(1 - (1 - cos^2(theta_1))/eta^2), cos(theta_1) = N.V
/// A unit vector; zero at total internal reflection.
template <class Real>
Vec3<Real> refracted(const Vec3<Real>& V, const Vec3<Real>& N, Real eta) noexcept {
    const Real cos_1 = dot(N, V);
    const Real radicand = Real(1) - (Real(1) - cos_1 * cos_1) / (eta * eta);
    const Real cos_2 = square_root(positive_part(radicand));
    const Vec3<Real> T = V * (Real(-1) / eta) - N * (cos_2 - cos_1 / eta);
    return select(radicand < Real(0), Vec3<Real>(Real(0)), T);
}

/// k_f of Whitted's formula, below; 0 at total internal reflection.
template <class Real>
Real whitted_factor(const Vec3<Real>& V_1, const Vec3<Real>& N, Real eta) noexcept {
    const Vec3<Real> across = N - V_1;
    const Real radicand = eta * eta * dot(V_1, V_1) - dot(across, across);
    const auto is_refracted = radicand > Real(0);
    return select(is_refracted, Real(1) / square_root(select(is_refracted, radicand, Real(1))),
                  Real(0));
}

/// T of Whitted 1980, "An improved illumination model for shaded display", CACM 23(6):
///     T = k_f (N - V') - N, k_f = 1/sqrt(eta^2 |V'|^2 - |N - V'|^2), V' = V/(N.V)
/// Of length 1/cos(theta_2): its part along N is -1. Zero at total internal reflection. Take
/// Heckbert's where N.V may be near 0.
template <class Real>
Vec3<Real> whitted_refracted(const Vec3<Real>& V, const Vec3<Real>& N, Real eta) noexcept {
    const Vec3<Real> V_1 = V * (Real(1) / dot(N, V));
    const Real k_f = whitted_factor(V_1, N, eta);
    return select(k_f > Real(0), (N - V_1) * k_f - N, Vec3<Real>(Real(0)));
}

}  // namespace scanlight::shading
