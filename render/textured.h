#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/frame.h"
#include "render/painted.h"
#include "render/scene.h"
#include "render/transform.h"
#include "shading/bump.h"
#include "shading/environment.h"
#include "shading/few.h"
#include "shading/illumination.h"
#include "shading/reflection.h"
#include "shading/refraction.h"
#include "shading/surface_textures.h"
#include "shading/texture_lookup.h"
#include "shading/whitted.h"

namespace scanlight::render {

// Textured surfaces, lit pixel by pixel. Templates on the number type, as in shading/real.h: both
// paths draw by them.

/// What is interpolated over a textured object for Phong shading: the normal; colours and (u, v)
/// if there are any; and the constant 1 that these are divided by.
struct TexturedAttributes {
    bool has_colors = false;
    bool has_uvs = false;

    constexpr int colors() const { return 3; }
    constexpr int uvs() const { return has_colors ? 6 : 3; }
    constexpr int q() const { return uvs() + (has_uvs ? 2 : 0); }
    constexpr int count() const { return has_colors || has_uvs ? q() + 1 : 3; }
};

inline TexturedAttributes textured_attributes(const Object& object) {
    const auto& textures = object.textures;
    const bool needs_uv = std::ranges::any_of(textures, &shading::SurfaceTextures::needs_uv);
    return {object.mesh->vertices.has_colors(), needs_uv && object.mesh->vertices.has_uvs()};
}

inline bool shows_environment(const shading::Material<float>& material) {
    return material.mirror != glm::vec3(0.0f) || material.refracted != glm::vec3(0.0f);
}

/// Whether an object's pixels are lit by this file's formulas: where there are textures, or an
/// environment that lights the object, is mirrored in it or seen through it.
inline bool is_textured(const Object& object, const Frame& frame) {
    return std::ranges::any_of(object.textures, &shading::SurfaceTextures::any) ||
           frame.diffuse != nullptr ||
           (frame.mirrored != nullptr && std::ranges::any_of(object.materials, shows_environment));
}

/// The textures of a material, on an object.
struct PlacedTextures {
    using Slot = std::optional<shading::PlacedTexture>;
    Slot ambient, diffuse, specular, exponent, opacity, emission, bump, normal;
    float bump_height, normal_scale;
    const shading::Environment* mirrored;  // of its own
};

/// Of each of the object's materials.
std::vector<PlacedTextures> placed_textures(const Object& object);

/// Of all of the object's textures.
shading::SiteNeeds site_needs(const Object& object);

/// The power of two, not below 1, by which (u, v) are divided when they are interpolated.
float uv_unit_of(const mesh::Vertices& vertices);

/// Where an object's faces lie, as textures ask for it.
struct FaceMatrices {
    glm::mat4 object_from_screen;  // as `Frame::world_from_screen`
    glm::mat4 world_from_screen;
    glm::mat3 gradients_from_object;  // as normals
};

FaceMatrices face_matrices(const Object& object, const Frame& frame);

/// Where the plane of a face goes from pixel to pixel, homogeneous: see `steps_at`.
template <class Real>
using FaceSteps = shading::PixelSteps<glm::vec<4, Real>>;

/// Of the plane normal.p = offset, object space, in the space to which `to` leads from the screen.
/// From pixel to pixel the plane's depth on the screen grows by what keeps a place on it. Zero
/// where it is seen edge-on.
template <class Real>
FaceSteps<Real> face_steps(const glm::mat4& object_from_screen, const glm::mat4& to,
                           const shading::Vec3<Real>& normal, Real offset) {
    using shading::select;
    const auto off_plane = [&](int column) {
        const glm::vec4& c = object_from_screen[column];
        return shading::dot(normal, shading::Vec3<Real>(Real(c.x), Real(c.y), Real(c.z))) -
               offset * Real(c.w);
    };
    const Real deeper = off_plane(2);
    const auto seen = deeper * deeper > Real(0);
    const Real inverse = Real(1) / select(seen, deeper, Real(1));
    const auto step = [&](int column) {
        const Real depth = -(off_plane(column) * inverse);
        const auto part = [&](int row) {
            return select(seen, Real(to[column][row]) + Real(to[2][row]) * depth, Real(0));
        };
        return glm::vec<4, Real>(part(0), part(1), part(2), part(3));
    };
    return {step(0), step(1)};
}

/// From what a pixel shows of a face to what the next ones show, world space; `point` and
/// `inverse_w` are of the pixel's own place.
template <class Real>
shading::PixelSteps<shading::Vec3<Real>> steps_at(const FaceSteps<Real>& steps,
                                                  const shading::Vec3<Real>& point,
                                                  Real inverse_w) {
    const auto moved = [&](const glm::vec<4, Real>& step) {
        return shading::Vec3<Real>((step.x - point.x * step.w) * inverse_w,
                                   (step.y - point.y * step.w) * inverse_w,
                                   (step.z - point.z * step.w) * inverse_w);
    };
    return {moved(steps.right), moved(steps.down)};
}

/// A gradient by the inverse transpose of the matrix that takes points.
template <class Real>
shading::Vec3<Real> transformed_gradient(const glm::mat3& m, const shading::Vec3<Real>& g) {
    return {direction_component(m, 0, g), direction_component(m, 1, g),
            direction_component(m, 2, g)};
}

/// (u, v) over a face: how they go on from pixel to pixel, homogeneous, see `uv_steps_at` (the
/// third is how w does); and their gradients.
template <class Real>
struct FaceUvs {
    shading::PixelSteps<shading::Vec3<Real>> steps;
    shading::UvGradients<Real> gradients;
};

/// Of a face whose u and v are linear functions of the point, see `mesh::Mesh`, and whose plane is
/// normal.p = offset; object space.
template <class Real>
FaceUvs<Real> face_uvs(const FaceMatrices& m, const shading::Vec3<Real>& normal, Real offset,
                       const glm::vec<4, Real>& u, const glm::vec<4, Real>& v) {
    using Vector = shading::Vec3<Real>;
    const auto steps = face_steps(m.object_from_screen, m.object_from_screen, normal, offset);
    const auto change = [](const glm::vec<4, Real>& function, const glm::vec<4, Real>& step) {
        return (function.x * step.x + function.y * step.y) +
               (function.z * step.z + function.w * step.w);
    };
    const auto changes = [&](const glm::vec<4, Real>& step) {
        return Vector(change(u, step), change(v, step), step.w);
    };
    const auto gradient = [&](const glm::vec<4, Real>& f) {
        return transformed_gradient(m.gradients_from_object, Vector(f.x, f.y, f.z));
    };
    return {{changes(steps.right), changes(steps.down)}, {gradient(u), gradient(v)}};
}

/// From (u, v) of what a pixel shows of a face to those of the next ones.
template <class Real>
shading::PixelSteps<glm::vec<2, Real>> uv_steps_at(
    const shading::PixelSteps<shading::Vec3<Real>>& steps, const glm::vec<2, Real>& uv,
    Real inverse_w) {
    const auto moved = [&](const shading::Vec3<Real>& step) {
        return glm::vec<2, Real>((step.x - uv.x * step.z) * inverse_w,
                                 (step.y - uv.y * step.z) * inverse_w);
    };
    return {moved(steps.right), moved(steps.down)};
}

/// What becomes of (u, v) on the way to a pixel: what is more than `most` is cut off, and the rest
/// is off by up to `error`, divided by q.
struct UvPrecision {
    float most, error;
};

/// By the roundings of floats, and by those of gradients, up to 17/32 of 2^-29 in u, v and q for
/// each pixel on the way: see `raster::attribute_plane`.
inline UvPrecision uv_precision(float uv_unit, raster::Viewport size) {
    const auto way = static_cast<float>(size.width + size.height);
    return {uv_unit * raster::attribute_limit, uv_unit * (0x1p-20f + way * 0x1p-27f)};
}

/// Tells faces on which texels cover pixels everywhere, so that nobody has to ask how large a pixel
/// is there: from (u, v) and w at their corners. In `uv_steps_at` all but the division is linear in
/// (u, v), and largest at a corner; so is w. Both paths must look up the same texels: faces on
/// which pixels are nearly as large do not count, nor do those where the roundings of (u, v) and of
/// depth might make them so.
template <class Real>
class MagnifiedFaces {
public:
    using Mask = decltype(Real(0) < Real(0));

    /// `texels`: the most of any texture.
    MagnifiedFaces(const shading::PixelSteps<shading::Vec3<Real>>& steps, const glm::vec2& texels,
                   const UvPrecision& precision)
        : steps_(steps), texels_(texels), precision_(precision) {}

    /// A corner of those faces that have it.
    void add(Mask has, const glm::vec<2, Real>& uv, Real w) {
        using shading::magnitude;
        using shading::select;
        const Real squared = shading::larger_square(uv_steps_at(steps_, uv, Real(1)), texels_);
        squared_ = select(has & (squared > squared_), squared, squared_);
        farthest_ = select(has & (w > farthest_), w, farthest_);
        nearest_ = select(has & (w < nearest_), w, nearest_);
        const Real u = magnitude(uv.x);
        const Real v = magnitude(uv.y);
        const Real most(precision_.most);
        const auto is_known = (u <= most) & (v <= most) & (w > Real(0));
        is_known_ = is_known_ & (is_known | !has);
    }

    /// `near`: the least w that is seen. Depth tells w to 1/100 as far as 2^17 times that.
    Mask are_sure(float near) const {
        const Real size = squared_ * (farthest_ * farthest_);
        const Real by_rounding = noise();
        return is_known_ & (farthest_ < Real(near * 0x1p17f)) & (by_rounding < Real(0x1p-4f)) &
               (size < Real(0.8f));
    }

private:
    /// How many texels a pixel seems to grow by the errors of (u, v), multiplied by how w changes.
    /// q is w of the nearest corner by w.
    Real noise() const {
        using shading::magnitude;
        using shading::select;
        const Real right = magnitude(steps_.right.z);
        const Real down = magnitude(steps_.down.z);
        const Real change = select(right > down, right, down) * farthest_;
        const float texels = texels_.x > texels_.y ? texels_.x : texels_.y;
        return Real(precision_.error * texels) * (farthest_ / nearest_) * change;
    }

    shading::PixelSteps<shading::Vec3<Real>> steps_;
    glm::vec2 texels_;
    UvPrecision precision_;
    Real squared_{0};
    Real farthest_{0};
    Real nearest_{0x1p60f};
    Mask is_known_ = Real(0) < Real(1);
};

/// A surface that is to be lit, with what its textures need. `outward` is -1 where its back is
/// seen, and 1 elsewhere; the vertices' `color`, if they have one, multiplies the body's own.
template <class Real>
struct TexturedSurface {
    shading::Surface<Real> surface;
    shading::TextureSite<Real> site;
    std::optional<shading::Rgb<Real>> color;
    Real outward;
};

/// A few surfaces: their textures are looked up together.
template <class Real>
using Surfaces = shading::Few<const TexturedSurface<Real>*>;

template <class Real>
shading::Sites<Real> sites_of(const Surfaces<Real>& surfaces) {
    return shading::few_of(surfaces.count(), [&](int i) { return &surfaces[i]->site; });
}

/// By what a texture, whose colour there is `texel`, and the vertices multiply a material's colour.
template <class Real>
shading::Rgb<Real> color_on(const TexturedSurface<Real>& s, const shading::Rgb<Real>& texel) {
    return s.color ? *s.color * texel : texel;
}

/// By what the body's own colour is multiplied.
template <class Real>
shading::Few<shading::Rgb<Real>> paints_on(const PlacedTextures& textures,
                                           const Surfaces<Real>& surfaces) {
    const auto paint_by = [&](auto&& texel_of) {
        return shading::few_of(surfaces.count(),
                               [&](int i) { return color_on(*surfaces[i], texel_of(i)); });
    };
    if (!textures.diffuse) return paint_by([](int) { return shading::Rgb<Real>(Real(1)); });
    const auto texels = shading::colors_at(*textures.diffuse, sites_of(surfaces));
    return paint_by([&](int i) { return texels[i]; });
}

/// A normal as the normal map leaves it.
template <class Real>
shading::Vec3<Real> mapped(const PlacedTextures& textures, const TexturedSurface<Real>& s,
                           const shading::Vec3<Real>& N) {
    if (!textures.normal) return N;
    const auto texel = shading::color_at(*textures.normal, s.site);
    const Real scale = Real(2 * textures.normal_scale) * s.outward;
    const shading::Vec3<Real> map((texel.x - Real(0.5)) * scale, (texel.y - Real(0.5)) * scale,
                                  texel.z * Real(2) - Real(1));
    return shading::mapped_normal(N, map, place_on(*textures.normal, s.site));
}

/// The normals as bump and normal map leave them.
template <class Real>
shading::Few<shading::Vec3<Real>> normals_on(const PlacedTextures& textures,
                                             const Surfaces<Real>& surfaces) {
    const auto smooth = [&](int i) { return surfaces[i]->surface.normal; };
    const auto wrinkled = [&](auto&& bumped) {
        return shading::few_of(surfaces.count(), [&](int i) {
            const auto& [point, N, view] = surfaces[i]->surface;
            return shading::kept_in_sight(mapped(textures, *surfaces[i], bumped(i)), N, view);
        });
    };
    if (!textures.bump)
        return textures.normal ? wrinkled(smooth) : shading::few_of(surfaces.count(), smooth);
    const auto gradients = shading::height_gradients_at(*textures.bump, sites_of(surfaces));
    return wrinkled([&](int i) {
        const Real height = surfaces[i]->outward * Real(textures.bump_height);
        return shading::bumped_normal(smooth(i), gradients[i] * height);
    });
}

/// What textures and vertices leave of a surface, and of its body's colour.
template <class Real>
struct Look {
    shading::Vec3<Real> normal;
    shading::Rgb<Real> paint;
};

/// At one place.
template <class Real>
Look<Real> look_of(const PlacedTextures& textures, const TexturedSurface<Real>& s) {
    const Surfaces<Real> one = shading::few_of(1, [&](int) { return &s; });
    return {normals_on(textures, one)[0], paints_on(textures, one)[0]};
}

template <class Real>
shading::Material<Real> textured(const shading::Material<float>& material,
                                 const PlacedTextures& textures, const TexturedSurface<Real>& s,
                                 const shading::Rgb<Real>& paint) {
    shading::Material<Real> result = painted(material, paint);
    if (textures.ambient) {
        result.ambient = shading::Rgb<Real>(material.ambient) *
                         color_on(s, shading::color_at(*textures.ambient, s.site));
    }
    if (textures.specular)
        result.specular = result.specular * shading::color_at(*textures.specular, s.site);
    if (textures.emission)
        result.emission = result.emission * shading::color_at(*textures.emission, s.site);
    return result;
}

/// 0 to 1.
template <class Real>
Real opacity_on(const shading::Material<float>& material, const PlacedTextures& textures,
                const shading::TextureSite<Real>& site) {
    const Real opacity(material.opacity);
    if (!textures.opacity) return opacity;
    using shading::select;
    const Real share = shading::positive_part(shading::number_at(*textures.opacity, site));
    return opacity * select(share < Real(1), share, Real(1));
}

/// The material with an n of each lane's own.
template <class Real>
shading::Material<Real, shading::VaryingExponent<Real>> with_exponent(
    const shading::Material<Real>& material, Real factor) {
    const Real n = Real(material.exponent.value()) * shading::positive_part(factor);
    const Real most(0x1p24f);
    using shading::select;
    return {
        material.ambient,      material.diffuse,  material.specular, {select(n < most, n, most)},
        material.transmission, material.facets,   material.opacity,  material.mirror,
        material.refracted,    material.emission, material.filter};
}

/// The environment mirrored in a surface and seen through it, over its local light: Whitted 1980,
/// with the environment in the place of rays.
template <class Real>
shading::Rgb<Real> with_environment(const shading::Rgb<Real>& local,
                                    const shading::Surface<Real>& surface,
                                    const shading::Material<float>& material, Real eta,
                                    const shading::Environment& environment) {
    using Color = shading::Rgb<Real>;
    const Color K_s(material.mirror);
    const auto S = shading::reflected(surface.view, surface.normal);
    const Color I_s = shading::light_from(environment, S);
    if (material.refracted == glm::vec3(0.0f)) return local + K_s * I_s;
    const Color K_t(material.refracted);
    const auto T = shading::refracted(surface.view, surface.normal, eta);
    const Color I_t = shading::light_from(environment, T);
    return shading::select(shading::dot(T, T) > Real(0),
                           shading::whitted(local, I_s, K_s, I_t, K_t),
                           shading::whitted_at_total_reflection(local, I_s, K_s, K_t));
}

/// What the surface sends without any light source: the ambient term, and what the environment
/// lights, and what is mirrored and refracted of the one that is, if any.
template <class Real, class Power>
shading::Rgb<Real> unlit_textured(const shading::Surface<Real>& surface,
                                  const shading::Material<Real, Power>& here,
                                  const shading::Material<float>& material, Real eta,
                                  const Frame& frame, const shading::Environment* mirrored) {
    auto intensity = shading::unlit<Real>(here, frame.lighting);
    if (frame.diffuse != nullptr)
        intensity = intensity + here.diffuse * shading::light_from(*frame.diffuse, surface.normal);
    if (mirrored == nullptr) return intensity;
    return with_environment(intensity, surface, material, eta, *mirrored);
}

/// eta_2/eta_1 as seen from the side that is seen: from behind it is the reciprocal.
template <class Real>
Real eta_seen(const shading::Material<float>& material, Real outward) {
    const auto eta = static_cast<float>(material.transmission.eta);
    using shading::select;
    return select(outward < Real(0), Real(1.0f / eta), Real(eta));
}

/// Whether textures say nothing of a surface but its normal and its body's colour, and nothing
/// around it lights it or is seen in it.
inline bool are_all_in_look(const PlacedTextures& textures, const Frame& frame) {
    const bool others =
        textures.ambient || textures.specular || textures.emission || textures.exponent;
    return !others && !textures.mirrored && frame.mirrored == nullptr && frame.diffuse == nullptr;
}

/// `illuminate`, of a textured surface that has this look, in the frame's light.
template <class Model, class Real, class Arriving>
shading::Rgb<Real> illuminate_textured(const Model& model, const TexturedSurface<Real>& s,
                                       const Look<Real>& look,
                                       const shading::Material<float>& material,
                                       const PlacedTextures& textures, const Frame& frame,
                                       const Arriving& arriving) {
    const shading::Surface<Real> surface{s.surface.point, look.normal, s.surface.view};
    const shading::Material<Real> here = textured(material, textures, s, look.paint);
    const auto unlit = unlit_textured(surface, here, material, eta_seen(material, s.outward), frame,
                                      textures.mirrored ? textures.mirrored : frame.mirrored);
    if (!textures.exponent)
        return with_lights(unlit, model, surface, here, frame.lighting, arriving);
    const Real factor = shading::number_at(*textures.exponent, s.site);
    return with_lights(unlit, model, surface, with_exponent(here, factor), frame.lighting,
                       arriving);
}

/// A pixel of it in all light, by the settings' model. Textures cost so much more than asking which
/// model it is that this is asked at each pixel.
raster::Rgba textured_pixel(const TexturedSurface<float>& surface,
                            const shading::Material<float>& material,
                            const PlacedTextures& textures, const Frame& frame,
                            const Settings& settings);

}  // namespace scanlight::render
