#pragma once

#include "shading/noise.h"

namespace scanlight::shading {

// Function textures: 0 or 1, or a number between, from a place on a texture or a point in space.

/// Whether a whole number is odd.
template <class Real>
auto is_odd(Real whole) noexcept {
    return fraction(whole * Real(0.5)) > Real(0.25);
}

/// A chessboard over [0, 1] x [0, 1]: 0 (dark) where floor(8 u) + floor(8 v) is odd, else 1. (The
/// chapter prints the product, which makes 16 dark cells of 64 where there are 32.)
template <class Real>
Real checkerboard(Real u, Real v, Real cells = Real(8)) noexcept {
    const auto cell = [&](Real x) {
        const Real whole = floored(x * cells);
        return select(whole < cells, whole, cells - Real(1));
    };
    return select(is_odd(cell(u) + cell(v)), Real(0), Real(1));
}

/// Stripes across u: 1 in the first half of each.
template <class Real>
Real stripes(Real u, Real count) noexcept {
    return select(fraction(u * count) < Real(0.5), Real(1), Real(0));
}

/// Waves across u and v, 0 to 1: for heights.
template <class Real>
Real waves(Real u, Real v, Real count) noexcept {
    const Real product = cosine_of_turns(u * count) * cosine_of_turns(v * count);
    return Real(0.5) + Real(0.5) * product;
}

/// Cubes of side 1 in space, by turns 1 and 0.
template <class Real>
Real checkered_space(const Vec3<Real>& p) noexcept {
    return select(is_odd(floored(p.x) + floored(p.y) + floored(p.z)), Real(0), Real(1));
}

/// The wood of the chapter, after A. Watt: the trunk's axis is w, its rings 60 units wide and
/// wavy, 40 of them light.
///     R' = R + 2 sin(20 alpha + w / 150),  light where R' mod 60 < 40
/// alpha is the direction of (u, v) in radians; a trunk is hundreds of units wide.
template <class Real>
Real ring_radius(const Vec3<Real>& p) noexcept {
    const Real R = square_root(p.x * p.x + p.y * p.y);
    const Real turns = Real(20) * turns_towards(p.y, p.x) + p.z * Real(1 / (150 * 2 * pi));
    return R + Real(2) * sine_of_turns(turns);
}
template <class Real>
Real wood(const Vec3<Real>& p) noexcept {
    const Real R = ring_radius(p);
    const Real in_ring = R - Real(60) * floored(R / Real(60));
    return select(in_ring < Real(40), Real(1), Real(0));
}

/// Marble (Perlin 1985): layers across x, a unit apart, bent by turbulence. 0 to 1.
template <class Real>
Real marble(const Vec3<Real>& p, Real bend) noexcept {
    return Real(0.5) + Real(0.5) * sine_of_turns(p.x + bend * turbulence(p, 6));
}

}  // namespace scanlight::shading
