#pragma once

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
    static Slopes<Real> at(const TexelImage& image, Whole<Real> index) noexcept {
        const Whole<Real> both = Wholes<Real>::fetched(image.words(), index + index);
        return {real_of_half<Real>(both), real_of_high_half<Real>(both)};
    }
};

/// -1 where a mirror image of a texture is seen, which falls where it rises; else 1.
template <class Real>
Real mirror_sign(Real u) noexcept {
    return select(wrapped(u * Real(0.5), Wrap::repeat) > Real(0.5), Real(-1), Real(1));
}

/// `sampled`, of slopes.
template <class Real>
Slopes<Real> slopes_at(const TexelImage& image, Filter filter, Wrap wrap, Real u, Real v,
                       Real squared_texels) noexcept {
    const auto slopes = sampled<TexelSlopes<Real>>(image, filter, wrap, u, v, squared_texels);
    if (wrap != Wrap::mirror) return slopes;
    return {slopes.u * mirror_sign(u), slopes.v * mirror_sign(v)};
}

}  // namespace scanlight::shading
