#pragma once

#include <optional>

#include "shading/real.h"

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

}  // namespace scanlight::shading
