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
    const Vec3<Real> H = half_vector(L, V);
    const Real NL = dot(N, L);
    const Real NV = dot(N, V);
    const Real NH = dot(N, H);
    const Real VH = dot(V, H);
    const auto is_seen_lit = (NL > Real(0)) & (NV > Real(0)) & (VH > Real(0));
    if (none(is_seen_lit)) return Rgb<Real>(Real(0));
    const Real sure_NV = select(NV > Real(1e-4), NV, Real(1e-4));
    const Real sure_VH = select(is_seen_lit, VH, Real(1));
    const Real D = facet_density(NH, slopes);
    const Real G_by_NV = facets_open_by_view(NH, NL, sure_NV, sure_VH);
    const Real facets = Real(slopes.reflection_constant()) * D * G_by_NV;
    return reflectance_at(sure_VH, material) * select(is_seen_lit, facets, Real(0));
}

}  // namespace scanlight::shading
