#pragma once

#include <cassert>
#include <cstdint>

#include "shading/angle.h"
#include "shading/base2.h"
#include "shading/few.h"
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

/// Two neighbouring texels along a side, the first from -1 on, and how near the second is.
template <class Real>
struct Neighbours {
    Whole<Real> first;
    Real share_of_second;
};

/// `u` wrapped; `size` of the side, in texels. Where nothing is repeated, what lies beyond the
/// middles of the outermost texels is theirs.
template <class Real>
Neighbours<Real> neighbours(Real u, Whole<Real> size, Wrap wrap) noexcept {
    using W = Wholes<Real>;
    const Real texels = W::real(size);
    Real x = u * texels - Real(0.5);
    if (wrap != Wrap::repeat) {
        const Real last = texels - Real(1);
        const Real positive = positive_part(x);
        x = select(positive < last, positive, last);
    }
    const Real whole = floored(x);
    return {W::truncated(whole), x - whole};
}

/// For a pair of neighbours: how much of each makes their mean, 16-bit integers that add up to
/// 16384.
inline constexpr std::int32_t whole_weight = 1 << 14;

template <class Real>
Whole<Real> pair_weights(Real share_of_second) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    const I second = W::truncated(share_of_second * Real(whole_weight) + Real(0.5));
    return W::shifted_left(second, 16) + (I(whole_weight) - second);
}

// What is wanted of texels, out of an image's words; nothing else of them is fetched. `of_pairs`
// takes weights and gives sums, whole numbers; `of_halves` takes one texel.

/// Their colours, linear.
template <class Real>
struct TexelColor {
    using W = Wholes<Real>;
    static constexpr int channels = 4;
    static constexpr bool may_be_halves = true;

    static Rgb<Real> of_pairs(const std::int32_t* words, Whole<Real> index,
                              Whole<Real> weights) noexcept {
        const Whole<Real> twice = index + index;
        const auto [red, green] = W::fetched_two(words, twice);
        const Whole<Real> blue = W::fetched(words + 2, twice + twice);
        const auto sum = [&](Whole<Real> pair) {
            return W::real(W::sum_of_products(pair, weights));
        };
        return {sum(red), sum(green), sum(blue)};
    }
    static Rgb<Real> of_halves(const std::int32_t* words, Whole<Real> index) noexcept {
        const auto [red_green, blue_alpha] = W::fetched_two(words, index);
        return {real_of_half<Real>(red_green), real_of_high_half<Real>(red_green),
                real_of_half<Real>(blue_alpha)};
    }
};

/// Their opacity.
template <class Real>
struct TexelAlpha {
    using W = Wholes<Real>;
    static constexpr int channels = 4;
    static constexpr bool may_be_halves = true;

    static Real of_pairs(const std::int32_t* words, Whole<Real> index,
                         Whole<Real> weights) noexcept {
        const Whole<Real> twice = index + index;
        return W::real(W::sum_of_products(W::fetched(words + 3, twice + twice), weights));
    }
    static Real of_halves(const std::int32_t* words, Whole<Real> index) noexcept {
        return real_of_high_half<Real>(W::fetched(words + 1, index + index));
    }
};

/// What a sum over pairs of an image is to be multiplied by.
inline float pair_unit(const TexelImage& image) noexcept {
    return image.unit() / static_cast<float>(whole_weight);
}

/// One texel.
template <class Part, class Real>
auto texel_at(const TexelImage& image, Whole<Real> index) noexcept {
    assert(image.channels() == Part::channels);
    if constexpr (Part::may_be_halves) {
        if (image.format() == TexelImage::Format::halves)
            return Part::of_halves(image.words(), index);
    }
    return Part::of_pairs(image.words(), index, Whole<Real>(whole_weight)) * Real(pair_unit(image));
}

/// One level of the pyramid, for each lane its own.
template <class Real>
struct TexelLevel {
    Whole<Real> width, height, begin;

    /// Level 0.
    explicit TexelLevel(const TexelImage& image) noexcept
        : width(image.width()), height(image.height()), begin(image.index(0, 0)) {}
    TexelLevel(const TexelImage& image, Whole<Real> level) noexcept
        : width(Wholes<Real>::fetched(image.widths(), level)),
          height(Wholes<Real>::fetched(image.heights(), level)),
          begin(Wholes<Real>::fetched(image.begins(), level)) {}

    /// From a row to the next.
    Whole<Real> stride() const noexcept { return width + Whole<Real>(2 * TexelImage::border); }
    Whole<Real> index(Whole<Real> x, Whole<Real> y) const noexcept {
        return begin + y * stride() + x;
    }
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
    return texel_at<Part, Real>(image, level.index(index(u, level.width), index(v, level.height)));
}

/// A place among four texels.
template <class Real>
struct TexelQuad {
    Whole<Real> first;      // of the four
    Real share_x, share_y;  // how near the others are
};

template <class Real>
TexelQuad<Real> quad_at(const TexelLevel<Real>& level, const Neighbours<Real>& x,
                        const Neighbours<Real>& y) noexcept {
    return {level.index(x.first, y.first), x.share_of_second, y.share_of_second};
}

/// Of wrapped u and v.
template <class Real>
TexelQuad<Real> quad_at(const TexelLevel<Real>& level, Real u, Real v, Wrap wrap) noexcept {
    return quad_at(level, neighbours<Real>(u, level.width, wrap),
                   neighbours<Real>(v, level.height, wrap));
}

// To call these for each vector of pixels, with all they need in memory, would take as long as a
// part of the work they do.

template <class Part, class Real>
[[gnu::always_inline]] inline auto mixed_pairs(const TexelImage& image,
                                               const TexelLevel<Real>& level,
                                               const TexelQuad<Real>& quad) noexcept {
    const Whole<Real> weights = pair_weights(quad.share_x);
    const auto row = [&](Whole<Real> first) {
        return Part::of_pairs(image.words(), first, weights);
    };
    return mixed(row(quad.first), row(quad.first + level.stride()), quad.share_y) *
           Real(pair_unit(image));
}

template <class Part, class Real>
auto mixed_halves(const TexelImage& image, const TexelLevel<Real>& level,
                  const TexelQuad<Real>& quad) noexcept {
    const auto row = [&](Whole<Real> first) {
        return mixed(Part::of_halves(image.words(), first),
                     Part::of_halves(image.words(), first + Whole<Real>(1)), quad.share_x);
    };
    return mixed(row(quad.first), row(quad.first + level.stride()), quad.share_y);
}

template <class Part, class Real>
[[gnu::always_inline]] inline auto mixed_texels(const TexelImage& image,
                                                const TexelLevel<Real>& level,
                                                const TexelQuad<Real>& quad) noexcept {
    assert(image.channels() == Part::channels);
    if constexpr (Part::may_be_halves) {
        if (image.format() == TexelImage::Format::halves)
            return mixed_halves<Part>(image, level, quad);
    }
    return mixed_pairs<Part>(image, level, quad);
}

template <class Part, class Real>
auto bilinear_texel(const TexelImage& image, const TexelLevel<Real>& level, Real u, Real v,
                    Wrap wrap) noexcept {
    return mixed_texels<Part>(image, level, quad_at(level, u, v, wrap));
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

/// A spot of a texture, and the square of a pixel's larger side there, in texels of its image.
template <class Real>
struct TextureSpot {
    Real u, v;
    Real squared_texels;  // 0 if the texture has no use for it
};

/// Where pixels of some lanes are larger than texels.
template <class Part, class Real>
auto trilinear_texel(const TexelImage& image, Real squared_texels, Real u, Real v,
                     Wrap wrap) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
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

/// The texture at a spot of it.
template <class Part, class Real>
auto sampled(const TexelImage& image, Filter filter, Wrap wrap,
             const TextureSpot<Real>& spot) noexcept {
    const Real x = wrapped(spot.u, wrap);
    const Real y = wrapped(spot.v, wrap);
    const TexelLevel<Real> finest(image);
    if (filter == Filter::nearest) return nearest_texel<Part>(image, finest, x, y);
    if (filter == Filter::bilinear || none(spot.squared_texels > Real(1)))
        return bilinear_texel<Part>(image, finest, x, y, wrap);
    return trilinear_texel<Part>(image, spot.squared_texels, x, y, wrap);
}

/// Whether a mean of four texels of the finest level is all that is asked for.
template <class Real>
bool are_finest(Filter filter, const Few<TextureSpot<Real>>& spots) noexcept {
    if (filter != Filter::trilinear) return filter == Filter::bilinear;
    for (int i = 0; i < spots.count(); ++i) {
        if (!none(spots[i].squared_texels > Real(1))) return false;
    }
    return true;
}

/// Calls `take(i, texel)` for each of a few spots: a mean of four texels.
template <class Part, class Real, class Take>
void sample_finest(const TexelImage& image, Wrap wrap, const Few<TextureSpot<Real>>& spots,
                   Take&& take) noexcept {
    const TexelLevel<Real> finest(image);
    const auto quads = few_of(spots.count(), [&](int i) {
        return quad_at(finest, wrapped(spots[i].u, wrap), wrapped(spots[i].v, wrap), wrap);
    });
    for (int i = 0; i < quads.count(); ++i)
        take(i, mixed_texels<Part>(image, finest, quads[i]));
}

/// Calls `take(i, texel)` for each of a few spots of the texture.
template <class Part, class Real, class Take>
void sample(const TexelImage& image, Filter filter, Wrap wrap, const Few<TextureSpot<Real>>& spots,
            Take&& take) noexcept {
    if (are_finest(filter, spots)) return sample_finest<Part>(image, wrap, spots, take);
    for (int i = 0; i < spots.count(); ++i)
        take(i, sampled<Part>(image, filter, wrap, spots[i]));
}

}  // namespace scanlight::shading
