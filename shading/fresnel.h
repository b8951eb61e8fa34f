#pragma once

#include <array>

#include "shading/vector.h"

namespace scanlight::shading {

// Fresnel 1823: the share of light that a smooth surface mirrors. Unpolarised light; `c` is the
// cosine of the angle between the normal and the light, 0 to 1. Results lie within 0 to 1 and are
// never NaN.

/// Of a dielectric, n = eta_2/eta_1 > 0 as seen from the light's side:
///     rho = 1/2 [tan^2(theta - psi)/tan^2(theta + psi) + sin^2(theta - psi)/sin^2(theta + psi)]
/// in the form of Cook & Torrance 1981, which takes no angle:
///     rho = 1/2 ((g - c)/(g + c))^2 [1 + ((c (g + c) - 1)/(c (g - c) + 1))^2],
///     g^2 = n^2 + c^2 - 1
/// 1 at total reflection, g^2 < 0, and at 90 degrees; ((n - 1)/(n + 1))^2 at 0; and 0 for n = 1,
/// since g^2 is then c^2 to the bit.
template <class Real>
Real fresnel(Real c, Real n) noexcept {
    const Real g2 = (n - Real(1)) * (n + Real(1)) + c * c;
    const Real g = square_root(positive_part(g2));
    const Real sum = select(g + c > Real(0), g + c, Real(1));
    const Real perpendicular = (g - c) / sum;
    const Real ratio = (c * sum - Real(1)) / (c * (g - c) + Real(1));
    const Real rho = Real(0.5) * (perpendicular * perpendicular) * (Real(1) + ratio * ratio);
    return select(g2 < Real(0), Real(1), rho);
}

/// rho, before the division.
template <class Real>
struct FresnelShare {
    Real mirrored, of;
};

/// What Fresnel's equations want to know of a metal in air, whose index is n + ik in this channel:
///     a_0 = n^2 - k^2 - 1, b = (2 n k)^2
template <class Number>
struct MetalIndex {
    Number a_0, b;
};

/// n and k no more than 1000.
template <class Number>
MetalIndex<Number> metal_index(Number n, Number k) noexcept {
    const Number nk2 = Number(2) * (n * k);
    return {(n - Number(1)) * (n + Number(1)) - k * k, nk2 * nk2};
}

/// Of such a metal. With s^2 = 1 - c^2, a = n^2 - k^2 - s^2, q = sqrt(a^2 + 4 n^2 k^2) and
/// p = sqrt((q + a)/2):
///     rho_perpendicular = (q + c^2 - 2 p c)/(q + c^2 + 2 p c)
///     rho_parallel = rho_perpendicular (c^2 q + s^4 - 2 p c s^2)/(c^2 q + s^4 + 2 p c s^2)
/// Born & Wolf, "Principles of Optics", 14.2; their mean over one denominator. For k = 0 it is the
/// dielectric's.
template <class Real, class Number>
FresnelShare<Real> metal_share(Real c, const MetalIndex<Number>& index) noexcept {
    const Real c2 = c * c;
    const Real s2 = positive_part(Real(1) - c2);
    const Real a = Real(index.a_0) + c2;
    const Real q = square_root(a * a + Real(index.b));
    const Real p = square_root(positive_part(q + a) * Real(0.5));
    const Real pc2 = Real(2) * (p * c);
    const Real whole = c2 * q + s2 * s2;
    return {positive_part(((q + c2) - pc2) * whole), ((q + c2) + pc2) * (whole + pc2 * s2)};
}

/// Of red, green and blue.
template <class Number>
using MetalIndices = std::array<MetalIndex<Number>, 3>;

template <class Number>
MetalIndices<Number> metal_indices(const Rgb<Number>& n, const Rgb<Number>& k) noexcept {
    return {metal_index(n.x, k.x), metal_index(n.y, k.y), metal_index(n.z, k.z)};
}

/// Of red, green and blue, before the division.
template <class Real>
using FresnelShares = std::array<FresnelShare<Real>, 3>;

template <class Real, class Number>
FresnelShares<Real> metal_shares(Real c, const MetalIndices<Number>& indices) noexcept {
    return {metal_share(c, indices[0]), metal_share(c, indices[1]), metal_share(c, indices[2])};
}

/// rho in each channel, with one division for all. Where the product of the three divisors runs out
/// of numbers, as it does next to 90 degrees, all is mirrored.
template <class Real>
Rgb<Real> divided(const FresnelShares<Real>& shares) noexcept {
    const auto& [red, green, blue] = shares;
    const Real of_green_blue = green.of * blue.of;
    const Real of_all = red.of * of_green_blue;
    const auto divides = of_all > Real(0x1p-100f);
    const Real inverse = Real(1) / select(divides, of_all, Real(1));
    const auto quotient = [&](Real mirrored, Real of_others) {
        const Real rho = mirrored * (of_others * inverse);
        return select(divides & (rho < Real(1)), rho, Real(1));
    };
    return {quotient(red.mirrored, of_green_blue), quotient(green.mirrored, red.of * blue.of),
            quotient(blue.mirrored, red.of * green.of)};
}

template <class Real, class Number>
Rgb<Real> fresnel_metal(Real c, const MetalIndices<Number>& indices) noexcept {
    return divided(metal_shares(c, indices));
}

/// Cook & Torrance 1981, for a metal of which no more is known than what it reflects straight back,
/// rho_0 in [0, 1): the index that would reflect as much with k = 0,
///     n = (1 + sqrt(rho_0))/(1 - sqrt(rho_0)).
template <class Real>
Real index_from_reflectance(Real rho_0) noexcept {
    const Real root = square_root(rho_0);
    return (Real(1) + root) / (Real(1) - root);
}

/// Cook & Torrance 1981: the colour of what a material mirrors, from its colour C_0 straight back
/// to that of the light, white, at 90 degrees, by one index n > 1 for all channels:
///     C = C_0 + (1 - C_0) (rho(c) - rho(1))+ / (1 - rho(1))
template <class Real>
Rgb<Real> fresnel_color(Real c, const Rgb<Real>& C_0, Real n) noexcept {
    const Real rho_0 = fresnel(Real(1), n);
    const Real share = positive_part(fresnel(c, n) - rho_0) / (Real(1) - rho_0);
    return C_0 + (Rgb<Real>(Real(1)) - C_0) * share;
}

}  // namespace scanlight::shading
