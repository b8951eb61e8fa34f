#pragma once

#include "shading/few.h"
#include "shading/luminance.h"
#include "shading/pattern.h"
#include "shading/slopes.h"
#include "shading/texture.h"

namespace scanlight::shading {

// What textures show: colours, single numbers, and how heights grow.

/// A few places where textures are looked up, each step of the way for all of them.
template <class Real>
using Sites = Few<const TextureSite<Real>*>;

template <class Real>
Few<TextureSpot<Real>> spots_on(const PlacedTexture& placed, const Sites<Real>& sites) noexcept {
    return few_of(sites.count(), [&](int i) { return spot_on(placed, *sites[i]); });
}

/// Of a texture: takes what a pattern shows, 0 to 1, to its own colours.
class FromLowToHigh {
public:
    [[gnu::always_inline]] explicit FromLowToHigh(const Texture& t)
        : texture_(t), are_plain_(t.low == Rgb<float>(0.0f) && t.high == Rgb<float>(1.0f)) {}

    template <class Real>
    Rgb<Real> operator()(const Rgb<Real>& share_of_high) const noexcept {
        if (are_plain_) return share_of_high;
        const Rgb<Real> low(texture_.low);
        return low + (Rgb<Real>(texture_.high) - low) * share_of_high;
    }

private:
    const Texture& texture_;
    bool are_plain_;
};

template <class Real>
Rgb<Real> between(const Texture& t, const Rgb<Real>& share_of_high) noexcept {
    return FromLowToHigh(t)(share_of_high);
}

template <class Real>
[[gnu::noinline]] Rgb<Real> solid_color(const Texture& t, const Vec3<Real>& p) noexcept {
    switch (t.pattern) {
        case Pattern::wood:
            return between(t, Rgb<Real>(wood(p)));
        case Pattern::marble:
            return between(t, Rgb<Real>(marble(p, Real(t.bend))));
        default:
            return between(t, Rgb<Real>(checkered_space(p)));
    }
}

template <class Real>
Real function_value(const Texture& t, Real x, Real y) noexcept {
    const Real count(t.count);
    switch (t.pattern) {
        case Pattern::stripes:
            return stripes(x, count);
        case Pattern::gradient:
            return x;
        case Pattern::waves:
            return waves(x, y, count);
        default:
            return checkerboard(x, y, count);
    }
}

/// Of a pattern that is a function of u and v.
template <class Real>
Rgb<Real> function_color(const Texture& t, Real u, Real v) noexcept {
    return between(t, Rgb<Real>(function_value(t, wrapped(u, t.wrap), wrapped(v, t.wrap))));
}

template <class Real>
Few<Rgb<Real>> image_colors(const PlacedTexture& placed, const Sites<Real>& sites) noexcept {
    const Texture& t = *placed.texture;
    const FromLowToHigh colored(t);
    Few<Rgb<Real>> colors;
    sample<TexelColor<Real>>(
        *t.image, t.filter, t.wrap, spots_on(placed, sites),
        [&](int, const Rgb<Real>& texel) { colors.add([&] { return colored(texel); }); });
    return colors;
}

/// By a pattern.
template <class Real>
Rgb<Real> pattern_color(const PlacedTexture& placed, const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (fills_space(t.pattern))
        return solid_color(t, mapped_point(placed.texture_from_world, site.point));
    const TextureSpot<Real> spot = spot_on(placed, site);
    return function_color(t, spot.u, spot.v);
}

/// The texture's colours at a few sites.
template <class Real>
[[gnu::noinline]] Few<Rgb<Real>> colors_at(const PlacedTexture& placed,
                                           const Sites<Real>& sites) noexcept {
    if (placed.texture->pattern == Pattern::image) return image_colors(placed, sites);
    return few_of(sites.count(), [&](int i) { return pattern_color(placed, *sites[i]); });
}

template <class Real>
Sites<Real> one_site(const TextureSite<Real>& site) noexcept {
    return few_of(1, [&](int) { return &site; });
}

/// At one.
template <class Real>
Rgb<Real> color_at(const PlacedTexture& placed, const TextureSite<Real>& site) noexcept {
    return colors_at(placed, one_site(site))[0];
}

/// The texture's opacity at a site: 1 but for images.
template <class Real>
[[gnu::noinline]] Real alpha_at(const PlacedTexture& placed,
                                const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (t.pattern != Pattern::image) return Real(1);
    return sampled<TexelAlpha<Real>>(*t.image, t.filter, t.wrap, spot_on(placed, site));
}

/// The one number of a texture at a site.
template <class Real>
Real number_at(const PlacedTexture& placed, const TextureSite<Real>& site) noexcept {
    if (placed.texture->channel == Channel::alpha) return alpha_at(placed, site);
    return luminance(color_at(placed, site));
}

/// How a height that fills space grows: by differences.
template <class Real>
Vec3<Real> solid_height_gradient(const Texture& t, const Vec3<Real>& p) noexcept {
    constexpr float step = 0x1p-6f;
    const auto slope = [&](int axis) {
        Vec3<Real> offset(Real(0));
        offset[axis] = Real(step);
        const Real rise =
            luminance(solid_color(t, p + offset)) - luminance(solid_color(t, p - offset));
        return rise * Real(0.5f / step);
    };
    return {slope(0), slope(1), slope(2)};
}

/// How a function's height grows with u and v: by differences over 1/512.
template <class Real>
[[gnu::noinline]] Slopes<Real> function_slopes(const Texture& t, Real u, Real v) noexcept {
    constexpr float step = 0x1p-10f;
    const auto height = [&](Real x, Real y) { return luminance(function_color(t, x, y)); };
    return {(height(u + Real(step), v) - height(u - Real(step), v)) * Real(0.5f / step),
            (height(u, v + Real(step)) - height(u, v - Real(step))) * Real(0.5f / step)};
}

/// The same of an image of slopes, from a texel to the next.
template <class Real>
Slopes<Real> rising_slopes(const Texture& t, const Slopes<Real>& slopes) noexcept {
    const float rise = luminance(t.high) - luminance(t.low);
    return {slopes.u * Real(rise * static_cast<float>(t.image->width())),
            slopes.v * Real(rise * static_cast<float>(t.image->height()))};
}

/// Calls `take(i, slopes)` for each of a few spots.
template <class Real, class Take>
void height_slopes(const Texture& t, const Few<TextureSpot<Real>>& spots, Take&& take) noexcept {
    if (t.pattern == Pattern::image) {
        return sample<TexelSlopes<Real>>(
            *t.image, t.filter, t.wrap, spots, [&](int i, const Slopes<Real>& slopes) {
                take(i, rising_slopes(t, slopes_there(slopes, t.wrap, spots[i])));
            });
    }
    for (int i = 0; i < spots.count(); ++i)
        take(i, function_slopes(t, spots[i].u, spots[i].v));
}

/// On the mesh's own (u, v).
template <class Real>
Few<Vec3<Real>> own_height_gradients(const PlacedTexture& placed,
                                     const Sites<Real>& sites) noexcept {
    const Texture& t = *placed.texture;
    Few<Vec3<Real>> gradients;
    height_slopes(t, spots_on(placed, sites), [&](int i, const Slopes<Real>& F) {
        const UvGradients<Real>& grad = *sites[i]->gradients;
        gradients.add(
            [&] { return grad.u * (F.u * Real(t.repeat.x)) + grad.v * (F.v * Real(t.repeat.y)); });
    });
    return gradients;
}

template <class Real>
[[gnu::noinline]] Few<Vec3<Real>> mapped_height_gradients(const PlacedTexture& placed,
                                                          const Sites<Real>& sites) noexcept {
    const Texture& t = *placed.texture;
    const auto places = few_of(sites.count(), [&](int i) { return place_on(placed, *sites[i]); });
    const auto spots =
        few_of(sites.count(), [&](int i) { return spot_at(t, places[i], *sites[i]); });
    Few<Vec3<Real>> gradients;
    height_slopes(t, spots, [&](int i, const Slopes<Real>& F) {
        gradients.add([&] { return places[i].grad_u * F.u + places[i].grad_v * F.v; });
    });
    return gradients;
}

template <class Real>
Vec3<Real> solid_height_gradient_at(const PlacedTexture& placed,
                                    const TextureSite<Real>& site) noexcept {
    const Vec3<Real> p = mapped_point(placed.texture_from_world, site.point);
    return gradient_before(placed.texture_from_world, solid_height_gradient(*placed.texture, p));
}

/// How the texture's luminance, a height, grows along the surface at a few sites, world space. An
/// image is one of slopes: see `slopes_of`.
template <class Real>
[[gnu::noinline]] Few<Vec3<Real>> height_gradients_at(const PlacedTexture& placed,
                                                      const Sites<Real>& sites) noexcept {
    const Texture& t = *placed.texture;
    if (!fills_space(t.pattern)) {
        return t.mapping == Mapping::uv ? own_height_gradients(placed, sites)
                                        : mapped_height_gradients(placed, sites);
    }
    return few_of(sites.count(),
                  [&](int i) { return solid_height_gradient_at(placed, *sites[i]); });
}

}  // namespace scanlight::shading
