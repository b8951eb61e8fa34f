#pragma once

#include <memory>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "shading/luminance.h"
#include "shading/mapping.h"
#include "shading/pattern.h"
#include "shading/sampling.h"
#include "shading/slopes.h"
#include "shading/texel_image.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// What is on a texture. The last three fill space and need no mapping.
enum class Pattern { image, checker, stripes, gradient, waves, wood, marble, solid_checker };

constexpr bool fills_space(Pattern pattern) {
    return pattern == Pattern::wood || pattern == Pattern::marble ||
           pattern == Pattern::solid_checker;
}

/// How a point finds its place on a texture: the mesh's own (u, v), or an auxiliary surface.
enum class Mapping { uv, planar, cylindrical, chapter_cylinder, spherical };

/// Where one number is wanted of a texture: its luminance (ITU-R BT.709), or its alpha.
enum class Channel { luminance, alpha };

/// A texture: a colour at each place of a surface. A pattern's numbers run from `low` to `high`; of
/// an image 0 is `low` and 1 is `high`, channel by channel.
struct Texture {
    Pattern pattern = Pattern::checker;
    Mapping mapping = Mapping::uv;
    glm::mat4 texture_from_object{1.0f};  // affine; not for the mesh's own (u, v)
    glm::vec2 repeat{1.0f};               // u' = u repeat + offset
    glm::vec2 offset{0.0f};
    float count = 8;                          // of cells, stripes, waves
    float bend = 1;                           // of marble
    Rgb<float> low{0.0f};                     // linear
    Rgb<float> high{1.0f};                    //
    std::shared_ptr<const TexelImage> image;  // of Pattern::image
    Filter filter = Filter::trilinear;
    Wrap wrap = Wrap::repeat;
    Channel channel = Channel::luminance;

    bool needs_uv() const { return !fills_space(pattern) && mapping == Mapping::uv; }
};

/// Where a texture is looked up: a point that is seen, world space.
template <class Real>
struct TextureSite {
    Vec3<Real> point;
    TexturePlace<Real> own;     // the mesh's (u, v)
    Vec3<Real> step_x, step_y;  // along the surface to what the next pixels show
};

/// A texture on an object.
struct PlacedTexture {
    const Texture* texture;
    glm::mat4 texture_from_world;
};

template <class Real>
Vec3<Real> mapped_point(const glm::mat4& m, const Vec3<Real>& p) noexcept {
    const auto row = [&](int i) {
        return (Real(m[0][i]) * p.x + Real(m[1][i]) * p.y) + (Real(m[2][i]) * p.z + Real(m[3][i]));
    };
    return {row(0), row(1), row(2)};
}

/// Of a number that has the gradient `g` where the matrix leads to, the gradient where it comes
/// from.
template <class Real>
Vec3<Real> gradient_before(const glm::mat4& m, const Vec3<Real>& g) noexcept {
    const auto part = [&](int i) {
        return dot(Vec3<Real>(Real(m[i][0]), Real(m[i][1]), Real(m[i][2])), g);
    };
    return {part(0), part(1), part(2)};
}

template <class Real>
[[gnu::noinline]] TexturePlace<Real> place_by(Mapping mapping, const Vec3<Real>& p) noexcept {
    switch (mapping) {
        case Mapping::cylindrical:
            return CylindricalMapping<float>{}(p);
        case Mapping::chapter_cylinder:
            return ChapterCylinderMapping<float>{}(p);
        case Mapping::spherical:
            return SphericalMapping{}(p);
        default:
            return PlanarMapping<float>{}(p);
    }
}

/// Gradients in world space.
template <class Real>
TexturePlace<Real> place_on(const PlacedTexture& placed, const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    TexturePlace<Real> place = site.own;
    if (t.mapping != Mapping::uv) {
        place = place_by(t.mapping, mapped_point(placed.texture_from_world, site.point));
        place.grad_u = gradient_before(placed.texture_from_world, place.grad_u);
        place.grad_v = gradient_before(placed.texture_from_world, place.grad_v);
    }
    const Real repeat_u(t.repeat.x);
    const Real repeat_v(t.repeat.y);
    return {place.u * repeat_u + Real(t.offset.x), place.v * repeat_v + Real(t.offset.y),
            place.grad_u * repeat_u, place.grad_v * repeat_v};
}

/// The square of a pixel's larger side on an image, in texels.
template <class Real>
Real squared_texels(const TexelImage& image, const TexturePlace<Real>& place,
                    const TextureSite<Real>& site) noexcept {
    const Real width(static_cast<float>(image.width()));
    const Real height(static_cast<float>(image.height()));
    const auto squared = [&](const Vec3<Real>& step) {
        const Real u = dot(place.grad_u, step) * width;
        const Real v = dot(place.grad_v, step) * height;
        return u * u + v * v;
    };
    const Real x = squared(site.step_x);
    const Real y = squared(site.step_y);
    return select(x > y, x, y);
}

template <class Real>
Rgb<Real> between(const Texture& t, Rgb<Real> share_of_high) noexcept {
    const Rgb<Real> low(t.low);
    return low + (Rgb<Real>(t.high) - low) * share_of_high;
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

template <class Real>
Rgb<Real> flat_color(const Texture& t, Real u, Real v, Real squared) noexcept {
    if (t.pattern == Pattern::image) {
        const auto texel = sampled<TexelColor<Real>>(*t.image, t.filter, t.wrap, u, v, squared);
        return between(t, texel);
    }
    return between(t, Rgb<Real>(function_value(t, wrapped(u, t.wrap), wrapped(v, t.wrap))));
}

template <class Real>
Real squared_texels_if_image(const Texture& t, const TexturePlace<Real>& place,
                             const TextureSite<Real>& site) noexcept {
    const bool asked = t.pattern == Pattern::image && t.filter == Filter::trilinear;
    return asked ? squared_texels(*t.image, place, site) : Real(0);
}

/// The texture's colour at a site.
template <class Real>
[[gnu::noinline]] Rgb<Real> color_at(const PlacedTexture& placed,
                                     const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (fills_space(t.pattern))
        return solid_color(t, mapped_point(placed.texture_from_world, site.point));
    const TexturePlace<Real> place = place_on(placed, site);
    return flat_color(t, place.u, place.v, squared_texels_if_image(t, place, site));
}

/// The texture's opacity at a site: 1 but for images.
template <class Real>
[[gnu::noinline]] Real alpha_at(const PlacedTexture& placed,
                                const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (t.pattern != Pattern::image) return Real(1);
    const TexturePlace<Real> place = place_on(placed, site);
    return sampled<TexelAlpha<Real>>(*t.image, t.filter, t.wrap, place.u, place.v,
                                     squared_texels_if_image(t, place, site));
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
    const auto height = [&](Real x, Real y) { return luminance(flat_color(t, x, y, Real(0))); };
    return {(height(u + Real(step), v) - height(u - Real(step), v)) * Real(0.5f / step),
            (height(u, v + Real(step)) - height(u, v - Real(step))) * Real(0.5f / step)};
}

/// The same of an image of slopes.
template <class Real>
Slopes<Real> image_slopes(const Texture& t, Real u, Real v, Real squared) noexcept {
    const Slopes<Real> slopes = slopes_at(*t.image, t.filter, t.wrap, u, v, squared);
    const float rise = luminance(t.high) - luminance(t.low);
    return {slopes.u * Real(rise * static_cast<float>(t.image->width())),
            slopes.v * Real(rise * static_cast<float>(t.image->height()))};
}

/// How the texture's luminance, a height, grows along the surface, world space. An image is one of
/// slopes: see `slopes_of`.
template <class Real>
[[gnu::noinline]] Vec3<Real> height_gradient_at(const PlacedTexture& placed,
                                                const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (fills_space(t.pattern)) {
        const Vec3<Real> p = mapped_point(placed.texture_from_world, site.point);
        return gradient_before(placed.texture_from_world, solid_height_gradient(t, p));
    }
    const TexturePlace<Real> place = place_on(placed, site);
    const Slopes<Real> F =
        t.pattern == Pattern::image
            ? image_slopes(t, place.u, place.v, squared_texels_if_image(t, place, site))
            : function_slopes(t, place.u, place.v);
    return place.grad_u * F.u + place.grad_v * F.v;
}

}  // namespace scanlight::shading
