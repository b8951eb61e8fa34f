#pragma once

#include <glm/vec3.hpp>

#include "shading/real.h"

namespace scanlight::shading {

/// A point or direction in world space.
template <class Real>
using Vec3 = glm::vec<3, Real>;

/// Red, green and blue: linear, not clamped. Products are taken channel by channel.
template <class Real>
using Rgb = glm::vec<3, Real>;

/// a.b; the order of the additions fixes the bits.
template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) noexcept {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// v / |v|, with one division; |v| from 2^-60 to 2^60. See `unit_or` for any other v.
template <class Real>
Vec3<Real> unit(const Vec3<Real>& v) noexcept {
    return v * (Real(1) / square_root(dot(v, v)));
}

/// `yes` where `condition` holds, else `no`.
template <class Mask, class Real>
Vec3<Real> select(Mask condition, const Vec3<Real>& yes, const Vec3<Real>& no) noexcept {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
            select(condition, yes.z, no.z)};
}

/// Whether |v| lies between 2^-60 and 2^60.
template <class Real>
auto has_direction(const Vec3<Real>& v) noexcept {
    const Real squared = dot(v, v);
    return (squared >= Real(0x1p-120f)) & (squared <= Real(0x1p120f));
}

/// unit(v) where v has a direction, else `fallback`: for sums that may vanish. Never NaN as long as
/// `fallback` is not.
template <class Real>
Vec3<Real> unit_or(const Vec3<Real>& v, const Vec3<Real>& fallback) noexcept {
    return select(has_direction(v), unit(v), fallback);
}

}  // namespace scanlight::shading
