#pragma once

#include "shading/base2.h"
#include "shading/facet_slopes.h"
#include "shading/power.h"
#include "shading/squared_angle.h"

namespace scanlight::shading {

// A rough surface as tiny mirrors, the microfacets, that lean in all directions: only those whose
// normal is H send L to V (Torrance & Sparrow 1967, "Theory for off-specular reflection from
// roughened surfaces", JOSA 57(9)). `c` = N.H is the cosine of the angle alpha by which they lean,
// m the root mean square of their slopes.

/// D of Torrance & Sparrow 1967, to be multiplied by a constant: the slopes' angles as a bell
/// curve.
///     e^-(alpha/m)^2
template <class Real>
Real gauss_facets(Real c, Real m) noexcept {
    const Real bell = exp_of_minus(squared_angle(c) / (m * m));
    return select(c > Real(0), bell, Real(0));
}

/// D of Beckmann & Spizzichino 1963, "The Scattering of Electromagnetic Waves from Rough Surfaces",
/// which Cook & Torrance 1981 take: the heights as a bell curve.
///     e^-(tan^2(alpha)/m^2) / (m^2 cos^4(alpha))
template <class Real>
Real beckmann_facets(Real c, Real m) noexcept {
    const Real cosine = select(c > Real(0), c, Real(1));
    const Real c2 = cosine * cosine;
    const Real sin2 = positive_part(Real(1) - cosine) * (Real(1) + cosine);
    const Real m2 = m * m;
    const Real inverse = Real(1) / (m2 * c2);
    const Real bell = exp_of_minus(sin2 * inverse);
    const Real density = select(bell > Real(0), bell * inverse * (inverse * m2), Real(0));
    return select(c > Real(0), density, Real(0));
}

/// D of Phong's shape, cos^n(alpha); Blinn 1977, "Models of light reflection for computer
/// synthesized pictures", SIGGRAPH.
template <class Real>
Real cosine_facets(Real c, const Exponent& n) noexcept {
    return select(c > Real(0), power(c, n), Real(0));
}

/// D: the share of the facets that lean by alpha, per steradian, times the constant of `slopes`.
/// Which distribution it is all pixels of a material have in common.
template <class Real>
Real facet_density(Real c, const FacetSlopes& slopes) noexcept {
    const auto constant = Real(slopes.constant());
    switch (slopes.distribution()) {
        case FacetDistribution::gauss:
            return constant * gauss_facets(c, Real(slopes.m()));
        case FacetDistribution::cosine:
            return constant * cosine_facets(c, slopes.exponent());
        case FacetDistribution::beckmann:
            break;
    }
    return constant * beckmann_facets(c, Real(slopes.m()));
}

/// The share G_m of a facet's mirrored light that no other facet is in the way of; and, with L in
/// the place of V, G_s of the light that arrives. Torrance & Sparrow 1967; Blinn 1977. Facets are
/// the sides of V-shaped grooves.
///     G_m = 2 (N.H)(N.V)/(V.H)
/// V.H > 0, which it is wherever there is an H.
template <class Real>
Real groove_share(Real NH, Real NV, Real VH) noexcept {
    return Real(2) * (NH * NV) / VH;
}

/// G: the share of a facet's light that neither arrives in a shadow nor leaves behind another.
///     G = min(1, G_m, G_s)
template <class Real>
Real facets_open(Real NH, Real NL, Real NV, Real VH) noexcept {
    const Real least = select(NL < NV, NL, NV);
    const Real share = groove_share(NH, least, VH);
    return select(share < Real(1), share, Real(1));
}

/// G/(N.V), with one division for both:
///     min(V.H, 2 (N.H) min(N.V, N.L)) / ((V.H)(N.V))
template <class Real>
Real facets_open_by_view(Real NH, Real NL, Real NV, Real VH) noexcept {
    const Real least = select(NL < NV, NL, NV);
    const Real groove = Real(2) * (NH * least);
    return select(groove < VH, groove, VH) / (VH * NV);
}

/// Beckmann's D times G/(N.V), with one division for all: where S = L + V, so that N.H = N.S/|S|
/// and V.H = |S|/2,
///     e^-((|S|^2 - (N.S)^2)/(m N.S)^2) |S|^2 min(|S|^2, 4 (N.S) min(N.V, N.L)) / (m^2 (N.S)^4 N.V)
/// 0 where N.S is so small that the divisor runs out of numbers.
template <class Real>
Real beckmann_facets_turned(Real NL, Real NV, Real NS, Real length, Real m) noexcept {
    const Real NS2 = NS * NS;
    const Real S2 = length * length;
    const Real others = NS2 * NV;
    const Real divisor = (m * m * NS2) * others;
    const auto divides = divisor > Real(0x1p-100f);
    const Real inverse = Real(1) / select(divides, divisor, Real(1));
    const Real sin2 = positive_part(length - NS) * (length + NS);
    const Real bell = exp_of_minus(sin2 * (others * inverse));
    const Real least = select(NL < NV, NL, NV);
    const Real groove = Real(4) * (NS * least);
    const Real open = select(groove < S2, groove, S2);
    return select(divides, bell * ((S2 * open) * inverse), Real(0));
}

}  // namespace scanlight::shading
