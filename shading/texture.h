#pragma once

#include <memory>
#include <optional>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "shading/mapping.h"
#include "shading/sampling.h"
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
    /// Whether it is told how large a pixel is on it.
    bool is_filtered() const { return pattern == Pattern::image && filter == Filter::trilinear; }
    /// As many as an image has between (u, v) = (0, 0) and (1, 1).
    glm::vec2 texels() const {
        return glm::abs(repeat) *
               glm::vec2(static_cast<float>(image->width()), static_cast<float>(image->height()));
    }
};

/// From what a pixel shows to what the next ones show, on the right and below.
template <class Value>
struct PixelSteps {
    Value right, down;
};

/// How fast the mesh's own u and v grow over a face: their gradients, world space.
template <class Real>
struct UvGradients {
    Vec3<Real> u, v;
};

/// Where a texture is looked up. The last three are not there unless a texture needs them.
template <class Real>
struct TextureSite {
    Vec3<Real> point;                                       // that is seen, world space
    glm::vec<2, Real> uv;                                   // the mesh's own
    std::optional<PixelSteps<glm::vec<2, Real>>> uv_steps;  // nor where texels cover pixels anyway
    std::optional<UvGradients<Real>> gradients;
    std::optional<PixelSteps<Vec3<Real>>> steps;  // along the surface, world space
};

/// What of a `TextureSite` textures need, beside (u, v).
struct SiteNeeds {
    bool point = false;
    bool uv_steps = false;
    glm::vec2 texels{0.0f};  // the most, of textures that need these
    bool gradients = false;
    bool steps = false;
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

template <class Real>
glm::vec<2, Real> repeated(const Texture& t, Real u, Real v) noexcept {
    return {u * Real(t.repeat.x) + Real(t.offset.x), v * Real(t.repeat.y) + Real(t.offset.y)};
}

/// By an auxiliary surface.
template <class Real>
[[gnu::noinline]] TexturePlace<Real> place_by_mapping(const PlacedTexture& placed,
                                                      const Vec3<Real>& point) noexcept {
    TexturePlace<Real> place =
        place_by(placed.texture->mapping, mapped_point(placed.texture_from_world, point));
    place.grad_u = gradient_before(placed.texture_from_world, place.grad_u);
    place.grad_v = gradient_before(placed.texture_from_world, place.grad_v);
    return place;
}

/// Gradients in world space.
template <class Real>
TexturePlace<Real> place_on(const PlacedTexture& placed, const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    const TexturePlace<Real> place =
        t.mapping == Mapping::uv
            ? TexturePlace<Real>{site.uv.x, site.uv.y, site.gradients->u, site.gradients->v}
            : place_by_mapping(placed, site.point);
    const glm::vec<2, Real> uv = repeated(t, place.u, place.v);
    return {uv.x, uv.y, place.grad_u * Real(t.repeat.x), place.grad_v * Real(t.repeat.y)};
}

/// The square of a pixel's larger side on an image of so many texels along u and v.
template <class Real>
Real larger_square(const PixelSteps<glm::vec<2, Real>>& steps, const glm::vec2& texels) noexcept {
    const auto squared = [&](const glm::vec<2, Real>& step) {
        const Real u = step.x * Real(texels.x);
        const Real v = step.y * Real(texels.y);
        return u * u + v * v;
    };
    const Real right = squared(steps.right);
    const Real down = squared(steps.down);
    return select(right > down, right, down);
}

/// How a place on a texture changes from pixel to pixel.
template <class Real>
PixelSteps<glm::vec<2, Real>> steps_on(const TexturePlace<Real>& place,
                                       const PixelSteps<Vec3<Real>>& steps) noexcept {
    return {{dot(place.grad_u, steps.right), dot(place.grad_v, steps.right)},
            {dot(place.grad_u, steps.down), dot(place.grad_v, steps.down)}};
}

/// Of a place by an auxiliary surface.
template <class Real>
TextureSpot<Real> spot_at(const Texture& t, const TexturePlace<Real>& place,
                          const TextureSite<Real>& site) noexcept {
    if (!t.is_filtered()) return {place.u, place.v, Real(0)};
    const glm::vec2 texels(t.image->width(), t.image->height());
    return {place.u, place.v, larger_square(steps_on(place, *site.steps), texels)};
}

template <class Real>
[[gnu::noinline]] TextureSpot<Real> mapped_spot(const PlacedTexture& placed,
                                                const TextureSite<Real>& site) noexcept {
    return spot_at(*placed.texture, place_on(placed, site), site);
}

/// On the mesh's own (u, v) it needs no gradients, which cost more than all else. Inlined for the
/// reason of `mixed_texels`.
template <class Real>
[[gnu::always_inline]] inline TextureSpot<Real> spot_on(const PlacedTexture& placed,
                                                        const TextureSite<Real>& site) noexcept {
    const Texture& t = *placed.texture;
    if (t.mapping != Mapping::uv) return mapped_spot(placed, site);
    const glm::vec<2, Real> uv = repeated(t, site.uv.x, site.uv.y);
    if (!t.is_filtered() || !site.uv_steps) return {uv.x, uv.y, Real(0)};
    return {uv.x, uv.y, larger_square(*site.uv_steps, t.texels())};
}

}  // namespace scanlight::shading
