#pragma once

#include <array>
#include <memory>

#include <glm/mat3x3.hpp>

#include "shading/mapping.h"
#include "shading/sampling.h"
#include "shading/texel_image.h"
#include "shading/vector.h"

namespace scanlight::shading {

// The light that comes from far away, by its direction (Blinn & Newell 1976, "Texture and
// reflection in computer generated images", CACM 19(10)). What is near is not mirrored right, and a
// body does not mirror itself.

/// How directions find their places on an image.
enum class EnvironmentLayout {
    latitudes,  // longitude and latitude, the z axis up
    sphere,     // what a mirror ball shows a viewer far away on the z axis
    cube,       // six faces (Greene 1986, "Environment mapping and other applications of world
                // projections", IEEE CG&A 6(11)), in OpenGL's order and layout: +x -x +y -y +z -z
};

struct Environment {
    EnvironmentLayout layout = EnvironmentLayout::latitudes;
    std::array<std::shared_ptr<const TexelImage>, 6> images;  // one, or six of a cube
    glm::mat3 environment_from_world{1.0f};  // a rotation, perhaps with a reflection
};

/// From axes of which y is up to those of latitudes.
inline constexpr glm::mat3 latitudes_from_y_up{0, 1, 0, 0, 0, 1, 1, 0, 0};

/// Where a unit direction is found: (u, v), and on which image.
template <class Real>
struct EnvironmentPlace {
    Real u, v;
    Real face;  // 0 but for a cube
};

/// m = 2 sqrt(S_x^2 + S_y^2 + (S_z + 1)^2), u = S_x / m + 1/2, v = S_y / m + 1/2. Straight away
/// from the viewer all directions of the rim meet: there u is 1/2.
template <class Real>
EnvironmentPlace<Real> place_on_ball(const Vec3<Real>& S) noexcept {
    const Real z = S.z + Real(1);
    const Real m = Real(2) * square_root((S.x * S.x + S.y * S.y) + z * z);
    return {quotient_or_zero(S.x, m) + Real(0.5), quotient_or_zero(S.y, m) + Real(0.5), Real(0)};
}

/// The largest component says which face; the others, divided by it, where on it. v is as OpenGL's
/// t, which counts from the image's first row.
template <class Real>
EnvironmentPlace<Real> place_on_cube(const Vec3<Real>& d) noexcept {
    const Vec3<Real> size(magnitude(d.x), magnitude(d.y), magnitude(d.z));
    const auto along_x = (size.x >= size.y) & (size.x >= size.z);
    const auto along_y = size.y >= size.z;  // and not along x
    const auto pick = [&](Real x, Real y, Real z) {
        return select(along_x, x, select(along_y, y, z));
    };
    const Real major = pick(d.x, d.y, d.z);
    const auto negative = major < Real(0);
    const Real sign = select(negative, Real(-1), Real(1));
    const Real s = pick(-d.z * sign, d.x, d.x * sign);
    const Real t = pick(-d.y, d.z * sign, -d.y);
    const Real half = quotient_or_zero(Real(0.5), magnitude(major));
    return {s * half + Real(0.5), t * half + Real(0.5),
            pick(Real(0), Real(2), Real(4)) + select(negative, Real(1), Real(0))};
}

/// The inverse, to a cube of side 2.
template <class Real>
Vec3<Real> direction_on_cube(int face, Real u, Real v) noexcept {
    const Real s = Real(2) * u - Real(1);
    const Real t = Real(2) * v - Real(1);
    const Real sign(face % 2 == 0 ? 1 : -1);
    if (face < 2) return {sign, -t, -s * sign};
    if (face < 4) return {s, sign, t * sign};
    return {s * sign, -t, sign};
}

template <class Real>
EnvironmentPlace<Real> place_in(EnvironmentLayout layout, const Vec3<Real>& direction) noexcept {
    if (layout == EnvironmentLayout::cube) return place_on_cube(direction);
    if (layout == EnvironmentLayout::sphere) return place_on_ball(direction);
    const TexturePlace<Real> place = SphericalMapping{}(direction);
    return {place.u, place.v, Real(0)};
}

template <class Real>
Rgb<Real> sampled_once(const TexelImage& image, EnvironmentLayout layout, Real u, Real v) noexcept {
    const TexelLevel<Real> finest(image);
    const Wrap around = layout == EnvironmentLayout::latitudes ? Wrap::repeat : Wrap::clamp;
    const auto x = neighbours<Real>(wrapped(u, around), finest.width, around);
    const auto y = neighbours<Real>(wrapped(v, Wrap::clamp), finest.height, Wrap::clamp);
    return mixed_texels<TexelColor<Real>>(image, finest, quad_at(finest, x, y));
}

/// The light that comes from a unit direction, world space.
template <class Real>
[[gnu::noinline]] Rgb<Real> light_from(const Environment& environment,
                                       const Vec3<Real>& direction) noexcept {
    const glm::mat3& m = environment.environment_from_world;
    const auto row = [&](int i) {
        return (Real(m[0][i]) * direction.x + Real(m[1][i]) * direction.y) +
               Real(m[2][i]) * direction.z;
    };
    const Vec3<Real> d(row(0), row(1), row(2));
    const EnvironmentPlace<Real> place = place_in(environment.layout, d);
    Rgb<Real> light(Real(0));
    const int faces = environment.layout == EnvironmentLayout::cube ? 6 : 1;
    for (int face = 0; face < faces; ++face) {
        const Real number(static_cast<float>(face));
        const auto here = (place.face >= number) & (place.face <= number);
        if (none(here)) continue;
        const auto& image = *environment.images[static_cast<std::size_t>(face)];
        const Rgb<Real> seen = sampled_once(image, environment.layout, place.u, place.v);
        light = select(here, seen, light);
    }
    return light;
}

/// The irradiance of a surface with each unit normal,
///     E(N) = integral of L(w) (N.w)+ dw,
/// divided by pi: what a body of K_d = 1 sends back. An image by latitudes, of the same axes as the
/// environment. The integral is a sum over `samples` x 2 `samples` directions.
std::shared_ptr<const TexelImage> diffuse_environment(const Environment& environment, int height,
                                                      int samples);

}  // namespace scanlight::shading
