#pragma once

#include "shading/blinn.h"
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

/// How light falls on the facets that mirror it to the viewer, and how these lean: cosines.
template <class Real>
struct FacetAngles {
    Real NL, NV, NH, VH;  // N.V no less than 1e-4; V.H is 1 where they are not seen lit
    decltype((Real(0) > Real(0)) & (Real(0) > Real(0))) are_seen_lit;
};

template <class Real>
FacetAngles<Real> facet_angles(const Vec3<Real>& N, const Vec3<Real>& L,
                               const Vec3<Real>& V) noexcept {
    const Vec3<Real> H = half_vector(L, V);
    const Real NL = dot(N, L);
    const Real NV = dot(N, V);
    const Real VH = dot(V, H);
    const auto are_seen_lit = (NL > Real(0)) & (NV > Real(0)) & (VH > Real(0));
    return {NL, select(NV > Real(1e-4), NV, Real(1e-4)), dot(N, H),
            select(are_seen_lit, VH, Real(1)), are_seen_lit};
}

/// (N.L) D G / (4 (N.L)(N.V)): the share of light that facets turn to the viewer.
template <class Real>
Real facets_share(const FacetAngles<Real>& a, const FacetSlopes& slopes) noexcept {
    const Real D = facet_density(a.NH, slopes);
    const Real G_by_NV = facets_open_by_view(a.NH, a.NL, a.NV, a.VH);
    const Real share = Real(slopes.reflection_constant()) * D * G_by_NV;
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
    return reflectance_at(angles.VH, material) * facets_share(angles, slopes);
}

}  // namespace scanlight::shading
