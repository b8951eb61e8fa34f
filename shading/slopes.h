#pragma once

#include <cstdint>

#include "shading/sampling.h"
#include "shading/texel_image.h"

namespace scanlight::shading {

/// An image of heights as the slopes that a bump map asks for (Blinn 1978, "Simulation of wrinkled
/// surfaces", SIGGRAPH, takes differences too): red and green of a texel are how much the
/// luminance grows along u and along v from one texel to the next, half the difference of the two
/// neighbours. Where texels are repeated, those of the other end are neighbours; elsewhere a height
/// neither rises nor falls across the image's edge. A mean of slopes is the slope of means, so that
/// they may be filtered like colours.
TexelImage slopes_of(const TexelImage& heights, Wrap wrap);

/// Two numbers of a texel.
template <class Real>
struct Slopes {
    Real u, v;

    friend Slopes operator+(const Slopes& a, const Slopes& b) { return {a.u + b.u, a.v + b.v}; }
    friend Slopes operator-(const Slopes& a, const Slopes& b) { return {a.u - b.u, a.v - b.v}; }
    friend Slopes operator*(const Slopes& a, Real factor) { return {a.u * factor, a.v * factor}; }
};

template <class Real>
struct TexelSlopes {
    static constexpr int channels = 2;
    static constexpr bool may_be_halves = false;

    static Slopes<Real> of_pairs(const std::int32_t* words, Whole<Real> index,
                                 Whole<Real> weights) noexcept {
        using W = Wholes<Real>;
        const auto [u, v] = W::fetched_two(words, index);
        return {W::real(W::sum_of_products(u, weights)), W::real(W::sum_of_products(v, weights))};
    }
};

/// -1 where a mirror image of a texture is seen, which falls where it rises; else 1.
template <class Real>
Real mirror_sign(Real u) noexcept {
    return select(wrapped(u * Real(0.5), Wrap::repeat) > Real(0.5), Real(-1), Real(1));
}

/// Slopes that were looked up at a spot, as the texture goes on there.
template <class Real>
Slopes<Real> slopes_there(const Slopes<Real>& slopes, Wrap wrap,
                          const TextureSpot<Real>& spot) noexcept {
    if (wrap != Wrap::mirror) return slopes;
    return {slopes.u * mirror_sign(spot.u), slopes.v * mirror_sign(spot.v)};
}

}  // namespace scanlight::shading
