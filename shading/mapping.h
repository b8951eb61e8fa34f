#pragma once

#include "shading/angle.h"
#include "shading/vector.h"

namespace scanlight::shading {

// From a point to a place on a texture, (u, v), by an auxiliary surface (Bier & Sloan 1986,
// "Two-part texture mappings", IEEE CG&A 6(9)). Texture space: the z axis is the axis of cylinders
// and spheres. u and v are not wrapped yet.

/// A place on a texture, and how fast u and v grow from point to point: their gradients, per unit
/// of the space in which the point lies. Where a mapping has no gradient it is zero.
template <class Real>
struct TexturePlace {
    Real u, v;
    Vec3<Real> grad_u, grad_v;
};

/// The plane's own two directions: u = s.(p - o), v = t.(p - o).
template <class Number>
struct PlanarMapping {
    Vec3<Number> s{Number(1), Number(0), Number(0)};
    Vec3<Number> t{Number(0), Number(1), Number(0)};
    Vec3<Number> origin{Number(0)};

    template <class Real>
    TexturePlace<Real> operator()(const Vec3<Real>& p) const noexcept {
        const Vec3<Real> S(s);
        const Vec3<Real> T(t);
        const Vec3<Real> from_origin = p - Vec3<Real>(origin);
        return {dot(S, from_origin), dot(T, from_origin), S, T};
    }
};

/// x / y, and 0 where y is 0.
template <class Real>
Real quotient_or_zero(Real x, Real y) noexcept {
    const auto some = magnitude(y) > Real(0);
    return select(some, x / select(some, y, Real(1)), Real(0));
}

/// In [0, 1), of an angle from -1/2 to 1/2 turns.
template <class Real>
Real once_around(Real turns) noexcept {
    return select(turns < Real(0), turns + Real(1), turns);
}

/// Around the axis: u = atan2(y, x) / 2 pi, v = (z - low) / height. On the axis u is 0.
template <class Number>
struct CylindricalMapping {
    Number low = 0;
    Number height = 1;

    template <class Real>
    TexturePlace<Real> operator()(const Vec3<Real>& p) const noexcept {
        const Real turn = quotient_or_zero(Real(0.5 / pi), p.x * p.x + p.y * p.y);
        const Real inverse_height = Real(1) / Real(height);
        return {once_around(turns_towards(p.y, p.x)),
                (p.z - Real(low)) * inverse_height,
                {-p.y * turn, p.x * turn, Real(0)},
                {Real(0), Real(0), inverse_height}};
    }
};

/// The chapter's way round the cylinder, (sqrt(x^2 + y^2) - |y|) / x, which is tan(psi / 2) of the
/// angle psi from the nearer end of the y axis: -1 to 1, twice around, the back a mirror image of
/// the front. u is (that + 1) / 2.
template <class Number>
struct ChapterCylinderMapping {
    Number low = 0;
    Number height = 1;

    template <class Real>
    static Real half_tangent(Real x, Real y) noexcept {
        return quotient_or_zero(square_root(x * x + y * y) - magnitude(y), x);
    }

    template <class Real>
    TexturePlace<Real> operator()(const Vec3<Real>& p) const noexcept {
        const Real r = square_root(p.x * p.x + p.y * p.y);
        const Real w = half_tangent(p.x, p.y);
        const Real by_x = quotient_or_zero(Real(1), r) - quotient_or_zero(w, p.x);
        const Real sign = select(p.y < Real(0), Real(-1), Real(1));
        const Real by_y = quotient_or_zero(quotient_or_zero(p.y, r) - sign, p.x);
        const Real inverse_height = Real(1) / Real(height);
        return {(w + Real(1)) * Real(0.5),
                (p.z - Real(low)) * inverse_height,
                {by_x * Real(0.5), by_y * Real(0.5), Real(0)},
                {Real(0), Real(0), inverse_height}};
    }
};

/// Longitude and latitude: u = atan2(y, x) / 2 pi, v = 1/2 + asin(z / r) / pi; v is 0 at the south
/// pole. At the poles u is 0.
struct SphericalMapping {
    template <class Real>
    TexturePlace<Real> operator()(const Vec3<Real>& p) const noexcept {
        const Real rho2 = p.x * p.x + p.y * p.y;
        const Real rho = square_root(rho2);
        const Real turn = quotient_or_zero(Real(0.5 / pi), rho2);
        const Real tilt = quotient_or_zero(Real(1 / pi), rho * (rho2 + p.z * p.z));
        return {once_around(turns_towards(p.y, p.x)),
                Real(0.5) + Real(2) * turns_towards(p.z, rho),
                {-p.y * turn, p.x * turn, Real(0)},
                {-p.x * p.z * tilt, -p.y * p.z * tilt, rho2 * tilt}};
    }
};

}  // namespace scanlight::shading
