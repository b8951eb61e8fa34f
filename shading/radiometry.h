#pragma once

#include "shading/angle.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// Energy: what arrives is scattered, mirrored, transmitted or absorbed,
///     I_i = I_d + I_s + I_t + I_v.
/// Returns the absorbed share I_v, for one number or for Rgb. A negative share means that more
/// leaves the surface than arrived.
template <class Energy>
Energy energy_left(const Energy& incident, const Energy& diffuse, const Energy& specular,
                   const Energy& transmitted) noexcept {
    return ((incident - diffuse) - specular) - transmitted;
}

/// Whether K_d + K_s' + K_t' <= 1 in each channel, up to the rounding of the sum: a material that
/// fails makes light out of nothing and is to be rejected.
template <class Real>
bool conserves_energy(const Rgb<Real>& diffuse, const Rgb<Real>& specular,
                      const Rgb<Real>& transmitted) noexcept {
    const Real rounding = Real(-0x1p-20f);
    const Rgb<Real> left = energy_left(Rgb<Real>(Real(1)), diffuse, specular, transmitted);
    return left.x >= rounding && left.y >= rounding && left.z >= rounding;
}

/// Solid angle, in steradians, of a small element of surface at distance r > 0:
///     d_omega = ds cos(theta) / r^2
/// theta lies between the element's normal and the direction to the source.
template <class Real>
Real solid_angle(Real area, Real cos_theta, Real r) noexcept {
    return area * cos_theta / (r * r);
}

/// Solid angle, in steradians, of a cone of the given half angle: 2 pi (1 - cos).
template <class Real>
Real cone_solid_angle(Real cos_half_angle) noexcept {
    return Real(2 * pi) * (Real(1) - cos_half_angle);
}

/// Flux of a point light of intensity I in every direction: F = 4 pi I.
template <class Real>
Real isotropic_flux(Real intensity) noexcept {
    return Real(4 * pi) * intensity;
}

/// Irradiance, flux per area, at distance r > 0 from a point light: E = dF/ds = I cos(theta) / r^2.
template <class Real>
Real irradiance(Real intensity, Real cos_theta, Real r) noexcept {
    return intensity * cos_theta / (r * r);
}

/// Intensity of the point light that sends the flux dF through the area ds at distance r, facing
/// it: I = dF/d_omega = (dF/ds) r^2.
template <class Real>
Real intensity_of(Real flux, Real area, Real r) noexcept {
    return flux / area * (r * r);
}

}  // namespace scanlight::shading
