#pragma once

#include "shading/exponent.h"
#include "shading/lambert.h"
#include "shading/power.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// What a surface lets through of the light behind it; 0 of an opaque one.
template <class Number>
struct Transmission {
    Rgb<Number> diffuse{Number(0)};   // K_dt: scattered, as by a lampshade
    Rgb<Number> specular{Number(0)};  // K_t: around the refracted direction, as by frosted glass
    Exponent exponent = 1;            // n_t
    double eta = 1;                   // eta_2/eta_1 > 0, the eye in medium 1; 1 for a thin sheet
};

/// Whether nothing comes through.
template <class Number>
bool is_opaque(const Transmission<Number>& transmission) noexcept {
    const Rgb<Number> nothing(Number(0));
    return transmission.diffuse == nothing && transmission.specular == nothing;
}

// The light behind a surface, N.L < 0, as it is seen from before it; Hall & Greenberg 1983, "A
// testbed for realistic image synthesis", IEEE Computer Graphics & Applications 3(8). Unit vectors
// pointing away from the surface, N.V >= 0. Without the full model's Fresnel factors and
// attenuation in the body.

/// Ideal diffuse transmission: (-N.L)+, to be multiplied by I_p K_dt.
template <class Real>
Real transmitted_diffuse(const Vec3<Real>& N, const Vec3<Real>& L) noexcept {
    return lambert(-N, L);
}

/// H_t, the normal of a facet that would refract L into V; eta = eta_2/eta_1, not 1.
///     H_t = -(V + eta L)/|V + eta L| for eta > 1, the negative of that for eta < 1
/// Zero where no facet could, -V.L < min(eta, 1/eta).
template <class Real>
Vec3<Real> transmitting_normal(const Vec3<Real>& L, const Vec3<Real>& V, double eta) noexcept {
    const Vec3<Real> nowhere(Real(0));
    const Vec3<Real> sum = (V + L * Real(eta)) * Real(eta > 1 ? -1 : 1);
    const auto exists = -dot(V, L) >= Real(eta < 1 ? eta : 1 / eta);
    return select(exists, unit_or(sum, nowhere), nowhere);
}

/// The cosine that makes the transmitted highlight: N.H_t; straight through, where eta = 1 and
/// there is no H_t, (-V.L).
template <class Real>
Real transmitted_cosine(const Vec3<Real>& N, const Vec3<Real>& L, const Vec3<Real>& V,
                        double eta) noexcept {
    if (eta == 1) return -dot(V, L);
    return dot(N, transmitting_normal(L, V, eta));
}

/// The highlight of a light behind the surface: ((N.H_t)+)^n_t, to be multiplied by I_p K_t.
/// 0 where N.L >= 0.
template <class Real>
Real transmitted_highlight(const Vec3<Real>& N, const Vec3<Real>& L, const Vec3<Real>& V,
                           double eta, const Exponent& n_t) noexcept {
    const Real highlight = power(positive_part(transmitted_cosine(N, L, V, eta)), n_t);
    return select(dot(N, L) < Real(0), highlight, Real(0));
}

}  // namespace scanlight::shading
