#pragma once

#include "shading/mapping.h"
#include "shading/vector.h"

namespace scanlight::shading {

// Blinn 1978, "Simulation of wrinkled surfaces", SIGGRAPH: the normal of a surface whose points
// were moved along it by F, without moving them.

template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Blinn's own form, unit:
///     N~ = P_u x P_v + F_u (n x P_v) + F_v (P_u x n),  n the unit normal along P_u x P_v
/// P_u and P_v are the surface's derivatives, F_u and F_v those of the height, in units of P. Where
/// P_u x P_v vanishes, at a pole, there is no normal to perturb: `pole`.
template <class Real>
Vec3<Real> wrinkled_normal(const Vec3<Real>& P_u, const Vec3<Real>& P_v, Real F_u, Real F_v,
                           const Vec3<Real>& pole) noexcept {
    const Vec3<Real> normal = cross(P_u, P_v);
    const Vec3<Real> n = unit_or(normal, pole);
    const Vec3<Real> wrinkled = normal + cross(n, P_v) * F_u + cross(P_u, n) * F_v;
    return select(dot(normal, normal) > Real(0), unit_or(wrinkled, n), pole);
}

/// The same from the height's gradient in space, unit:
///     N~ = n - (grad F - n (n.grad F))
/// since (n x P_v) / |P_u x P_v| = -grad u along the surface, and so for v (Mikkelsen 2010, "Bump
/// mapping unparametrized surfaces on the GPU"). Needs no P_u and P_v, and has no poles.
template <class Real>
Vec3<Real> bumped_normal(const Vec3<Real>& n, const Vec3<Real>& grad_F) noexcept {
    return unit_or(n - (grad_F - n * dot(n, grad_F)), n);
}

/// From a normal map: (x, y, z) in the directions in which u grows, v grows, and the normal.
template <class Real>
Vec3<Real> mapped_normal(const Vec3<Real>& n, const Vec3<Real>& map,
                         const TexturePlace<Real>& place) noexcept {
    const Vec3<Real> nothing(Real(0));
    const auto mirrored = dot(n, cross(place.grad_u, place.grad_v)) < Real(0);
    const Real sign = select(mirrored, Real(-1), Real(1));
    const Vec3<Real> tangent = unit_or(cross(place.grad_v, n) * sign, nothing);
    const Vec3<Real> bitangent = unit_or(cross(n, place.grad_u) * sign, nothing);
    return unit_or(tangent * map.x + bitangent * map.y + n * map.z, n);
}

/// A normal that was turned away from a viewer who sees the surface: its part along the view is
/// turned round, so that nothing jumps where it comes out of sight.
template <class Real>
Vec3<Real> kept_in_sight(const Vec3<Real>& bumped, const Vec3<Real>& n,
                         const Vec3<Real>& view) noexcept {
    const Real along = dot(bumped, view);
    const auto away = along < Real(0);
    if (none(away)) return bumped;
    const auto lost = away & (dot(n, view) > Real(0));
    return select(lost, bumped - view * (Real(2) * along), bumped);
}

}  // namespace scanlight::shading
