#pragma once

#include "shading/angle.h"
#include "shading/base2.h"
#include "shading/texel_image.h"
#include "shading/vector.h"

namespace scanlight::shading {

template <class Value, class Real>
Value mixed(const Value& a, const Value& b, Real share_of_b) noexcept {
    return a + (b - a) * share_of_b;
}

/// What lies beyond the edges of a texture: itself again, its outermost texels, its mirror image.
enum class Wrap { repeat, clamp, mirror };

/// How texels become a surface: the nearest one; a mean of four (Catmull 1974); of four on each of
/// two levels of the pyramid (Williams 1983).
enum class Filter { nearest, bilinear, trilinear };

/// Of any u: in [0, 1], or what a texture can be told of it. Too large and NaN count as 0.
template <class Real>
Real wrapped(Real u, Wrap wrap) noexcept {
    const Real known = select(magnitude(u) < Real(0x1p22f), u, Real(0));
    if (wrap == Wrap::clamp) {
        const Real positive = positive_part(known);
        return select(positive < Real(1), positive, Real(1));
    }
    if (wrap == Wrap::repeat) return fraction(known);
    const Real twice = Real(2) * fraction(known * Real(0.5));
    return select(twice > Real(1), Real(2) - twice, twice);
}

/// Two neighbouring texels along a side, and how near the second is.
template <class Real>
struct Neighbours {
    Whole<Real> first, second;
    Real share_of_second;
};

/// `u` wrapped; `size` of the side, in texels.
template <class Real>
Neighbours<Real> neighbours(Real u, Whole<Real> size, Wrap wrap) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    const Real x = u * W::real(size) - Real(0.5);
    const Real whole = floored(x);
    const I first = W::truncated(whole);
    const I second = first + I(1);
    const I last = size - I(1);
    const bool around = wrap == Wrap::repeat;
    return {select(first < I(0), around ? last : I(0), first),
            select(second > last, around ? I(0) : last, second), x - whole};
}

// What is wanted of texels. Nothing else of them is fetched.

/// Their colours, linear.
template <class Real>
struct TexelColor {
    static Rgb<Real> at(const TexelImage& image, Whole<Real> index) noexcept {
        const auto [red_green, blue_alpha] = Wholes<Real>::fetched_two(image.words(), index);
        return {real_of_half<Real>(red_green), real_of_high_half<Real>(red_green),
                real_of_half<Real>(blue_alpha)};
    }
};

/// Their opacity.
template <class Real>
struct TexelAlpha {
    static Real at(const TexelImage& image, Whole<Real> index) noexcept {
        using W = Wholes<Real>;
        const Whole<Real> blue_alpha = W::fetched(image.words() + 1, index + index);
        return real_of_high_half<Real>(blue_alpha);
    }
};

/// One level of the pyramid, for each lane its own.
template <class Real>
struct TexelLevel {
    Whole<Real> width, height, begin;

    /// Level 0.
    explicit TexelLevel(const TexelImage& image) noexcept
        : width(image.width()), height(image.height()), begin(0) {}
    TexelLevel(const TexelImage& image, Whole<Real> level) noexcept
        : width(Wholes<Real>::fetched(image.widths(), level)),
          height(Wholes<Real>::fetched(image.heights(), level)),
          begin(Wholes<Real>::fetched(image.begins(), level)) {}
};

template <class Part, class Real>
auto nearest_texel(const TexelImage& image, const TexelLevel<Real>& level, Real u,
                   Real v) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    const auto index = [](Real x, I size) {
        const I whole = W::truncated(x * W::real(size));
        return select(whole < size, whole, size - I(1));
    };
    return Part::at(image,
                    level.begin + index(v, level.height) * level.width + index(u, level.width));
}

template <class Part, class Real>
auto bilinear_texel(const TexelImage& image, const TexelLevel<Real>& level,
                    const Neighbours<Real>& x, const Neighbours<Real>& y) noexcept {
    const auto row = [&](Whole<Real> j) {
        const Whole<Real> begin = level.begin + j * level.width;
        return mixed(Part::at(image, begin + x.first), Part::at(image, begin + x.second),
                     x.share_of_second);
    };
    return mixed(row(y.first), row(y.second), y.share_of_second);
}

template <class Part, class Real>
auto bilinear_texel(const TexelImage& image, const TexelLevel<Real>& level, Real u, Real v,
                    Wrap wrap) noexcept {
    return bilinear_texel<Part>(image, level, neighbours<Real>(u, level.width, wrap),
                                neighbours<Real>(v, level.height, wrap));
}

/// How large a pixel is on the texture, as a level of its pyramid: 0 where a texel covers a pixel
/// or more. `squared` is the square of the larger of the pixel's two sides, in texels of level 0.
template <class Real>
Real level_of(const TexelImage& image, Real squared) noexcept {
    const Real last(static_cast<float>(image.levels() - 1));
    const auto shrunk = (squared > Real(1)) & (squared < Real(0x1p60f));
    const Real level = Real(0.5) * log2_of(select(shrunk, squared, Real(1)));
    const Real beyond = select(squared >= Real(0x1p60f), last, level);
    return select(beyond < last, beyond, last);
}

template <class Part, class Real>
auto trilinear_texel(const TexelImage& image, Real squared_texels, Real u, Real v,
                     Wrap wrap) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    if (none(squared_texels > Real(1)))
        return bilinear_texel<Part>(image, TexelLevel<Real>(image), u, v, wrap);
    const Real level = level_of(image, squared_texels);
    const I fine = W::truncated(level);
    const Real share = level - W::real(fine);
    const auto texel = bilinear_texel<Part>(image, TexelLevel<Real>(image, fine), u, v, wrap);
    const auto between = share > Real(0);
    if (none(between)) return texel;
    const I coarse = select(between, fine + I(1), fine);
    return mixed(texel, bilinear_texel<Part>(image, TexelLevel<Real>(image, coarse), u, v, wrap),
                 share);
}

/// The texture at (u, v), where a pixel has so many texels on a side; see `level_of`.
template <class Part, class Real>
auto sampled(const TexelImage& image, Filter filter, Wrap wrap, Real u, Real v,
             Real squared_texels) noexcept {
    const Real x = wrapped(u, wrap);
    const Real y = wrapped(v, wrap);
    if (filter == Filter::trilinear)
        return trilinear_texel<Part>(image, squared_texels, x, y, wrap);
    const TexelLevel<Real> finest(image);
    return filter == Filter::bilinear ? bilinear_texel<Part>(image, finest, x, y, wrap)
                                      : nearest_texel<Part>(image, finest, x, y);
}

}  // namespace scanlight::shading
