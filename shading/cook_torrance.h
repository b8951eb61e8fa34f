#pragma once

#include "shading/lambert.h"
#include "shading/microfacets.h"
#include "shading/radiometry.h"
#include "shading/reflectance.h"

namespace scanlight::shading {

/// What Cook and Torrance's model has to know of a surface beside its own colour.
struct Microfacets {
    FacetSlopes slopes{FacetDistribution::beckmann, 0.2};
    Reflectance reflectance;
    double share = 0;  // K_s, 0 to 1: of the light that meets facets; the body has K_d = 1 - K_s
};

/// How light falls on the facets that mirror it to the viewer, and how these lean. With
/// S = L + V, their normal is H = S/|S|: N.H = N.S/|S|, and V.H = |S|/2.
template <class Real>
struct FacetAngles {
    Real NL, NV;      // cosines; N.V no less than 1e-4
    Real NS, length;  // N.S and |S|; 1 and 2 where the facets are not seen lit
    decltype((Real(0) > Real(0)) & (Real(0) > Real(0))) are_seen_lit;

    Real NH() const noexcept { return NS / length; }
    Real VH() const noexcept { return Real(0.5) * length; }
};

template <class Real>
FacetAngles<Real> facet_angles(const Vec3<Real>& N, const Vec3<Real>& L,
                               const Vec3<Real>& V) noexcept {
    const Vec3<Real> S = L + V;
    const Real NL = dot(N, L);
    const Real NV = dot(N, V);
    const Real squared = dot(S, S);
    const auto are_seen_lit = (NL > Real(0)) & (NV > Real(0)) & (squared >= Real(0x1p-120f));
    return {NL, select(NV > Real(1e-4), NV, Real(1e-4)), select(are_seen_lit, NL + NV, Real(1)),
            square_root(select(are_seen_lit, squared, Real(4))), are_seen_lit};
}

/// D G/(N.V).
template <class Real>
Real facets_turned(const FacetAngles<Real>& a, const FacetSlopes& slopes) noexcept {
    if (slopes.distribution() == FacetDistribution::beckmann) {
        return Real(slopes.constant()) *
               beckmann_facets_turned(a.NL, a.NV, a.NS, a.length, Real(slopes.m()));
    }
    const Real NH = a.NH();
    return facet_density(NH, slopes) * facets_open_by_view(NH, a.NL, a.NV, a.VH());
}

/// (N.L) D G / (4 (N.L)(N.V)): the share of light that facets turn to the viewer.
template <class Real>
Real facets_share(const FacetAngles<Real>& a, const FacetSlopes& slopes) noexcept {
    const Real share = Real(slopes.reflection_constant()) * facets_turned(a, slopes);
    return select(a.are_seen_lit, share, Real(0));
}

/// The highlight of Cook & Torrance 1981, "A reflectance model for computer graphics", SIGGRAPH.
///     (N.L) R_s, R_s = D G rho / (4 (N.L)(N.V)), in each channel; to be multiplied by E K_s
/// with rho at the angle between V and H. Unit vectors pointing away from the surface. 0 where
/// N.L <= 0 or N.V <= 0. N.L is nowhere divided by, and N.V counts as no less than 1e-4. At the
/// mirror direction it grows without bound towards 90 degrees.
/// The paper's constant is 1/pi, with a D that lacks 1/pi, which is four times too bright to keep
/// energy: FacetConstant::textbook.
template <class Real>
Rgb<Real> cook_torrance(const Vec3<Real>& N, const Vec3<Real>& L, const Vec3<Real>& V,
                        const FacetSlopes& slopes, const Reflectance& material) noexcept {
    const FacetAngles<Real> angles = facet_angles(N, L, V);
    if (none(angles.are_seen_lit)) return Rgb<Real>(Real(0));
    return reflectance_at(angles.VH(), material) * facets_share(angles, slopes);
}

}  // namespace scanlight::shading
