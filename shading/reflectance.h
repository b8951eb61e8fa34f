#pragma once

#include "shading/few.h"
#include "shading/fresnel.h"

namespace scanlight::shading {

/// What a smooth piece of a material mirrors, channel by channel, in air. Make one with a function
/// below.
struct Reflectance {
    enum class Kind { dielectric, metal, shifted };

    Kind kind = Kind::dielectric;
    Rgb<double> n{1.5};  // the index is n + ik; a dielectric's is the same in all channels
    Rgb<double> k{0};
    Rgb<double> C_0{0.04};           // at 0 degrees
    MetalIndices<double> indices{};  // of a metal: `metal_indices(n, k)`
};

/// Of a dielectric of index `n` > 0: nearly grey, so that highlights have the light's colour.
Reflectance dielectric(double n) noexcept;

/// Of a metal of index n + ik in each channel; n and k count as no more than 1000.
Reflectance metal(const Rgb<double>& n, const Rgb<double>& k) noexcept;

/// Of a material of which only the colour is known that it mirrors at 0 degrees: by the index that
/// would give as much, channel by channel. Each channel counts as no more than 0.999.
Reflectance metal_of_color(const Rgb<double>& C_0) noexcept;

/// The same material in Cook and Torrance's fast form, by one index for all channels: see
/// `fresnel_color`.
Reflectance shifted(const Reflectance& material) noexcept;

/// rho, at an angle of cosine `c`. Of which kind the material is all its pixels have in common.
template <class Real>
Rgb<Real> reflectance_at(Real c, const Reflectance& material) noexcept {
    const auto& [kind, n, k, C_0, indices] = material;
    switch (kind) {
        case Reflectance::Kind::metal:
            return fresnel_metal(c, indices);
        case Reflectance::Kind::shifted:
            return fresnel_color(c, Rgb<Real>(C_0), Real(n.x));
        case Reflectance::Kind::dielectric:
            break;
    }
    return Rgb<Real>(fresnel(c, Real(n.x)));
}

/// `reflectance_at` a few angles, their cosines `cosine_at(i)`. Calls `take(i, rho)` for each: of
/// metals first all roots are drawn, then all is divided.
template <class CosineAt, class Take>
void reflectances_at(int count, const CosineAt& cosine_at, const Reflectance& material,
                     Take&& take) noexcept {
    if (material.kind == Reflectance::Kind::metal) {
        const auto shares =
            few_of(count, [&](int i) { return metal_shares(cosine_at(i), material.indices); });
        for (int i = 0; i < count; ++i)
            take(i, divided(shares[i]));
    } else {
        for (int i = 0; i < count; ++i)
            take(i, reflectance_at(cosine_at(i), material));
    }
}

}  // namespace scanlight::shading
