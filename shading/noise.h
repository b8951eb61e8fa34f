#pragma once

#include "shading/angle.h"
#include "shading/vector.h"
#include "shading/whole.h"

namespace scanlight::shading {

// Perlin 1985, "An image synthesizer", SIGGRAPH; with the smoother blend of his "Improving noise",
// SIGGRAPH 2002. The lattice's gradients come from a hash instead of a table.

/// Thorough mixing of the bits of three whole numbers.
template <class Real>
Whole<Real> lattice_hash(Whole<Real> x, Whole<Real> y, Whole<Real> z) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    I h = W::sum(W::sum(W::product(x, I(0x27d4eb2f)), W::product(y, I(0x165667b1))),
                 W::product(z, I(0x2c1b3c6d)));
    for (const int multiplier : {0x45d9f3b, 0x119de1f3}) {
        h = h ^ W::shifted_right(h, 16);
        h = W::product(h, I(multiplier));
    }
    return h ^ W::shifted_right(h, 16);
}

/// One of 2^30 gradients, each part from -1 to 1, times the way from the lattice's point.
template <class Real>
Real lattice_slope(Whole<Real> hash, const Vec3<Real>& way) noexcept {
    using W = Wholes<Real>;
    const auto part = [&](int shift) {
        const auto ten_bits = W::shifted_right(hash, shift) & Whole<Real>(1023);
        return W::real(ten_bits) * Real(2.0f / 1023.0f) - Real(1);
    };
    return dot(Vec3<Real>(part(0), part(10), part(20)), way);
}

/// From 0 to 1 with neither slope nor curvature at the ends.
template <class Real>
Real fade(Real t) noexcept {
    return t * t * t * (t * (t * Real(6) - Real(15)) + Real(10));
}

template <class Real>
Real mixed(Real a, Real b, Real share_of_b) noexcept {
    return a + (b - a) * share_of_b;
}

/// Smooth randomness: 0 at the points of the unit lattice, within about -1 to 1 between them.
/// Coordinates below 2^22; others, and NaN, count as 0.
template <class Real>
Real noise(const Vec3<Real>& p) noexcept {
    using W = Wholes<Real>;
    using I = Whole<Real>;
    const auto known = [](Real x) { return select(magnitude(x) < Real(0x1p22f), x, Real(0)); };
    const Vec3<Real> at(known(p.x), known(p.y), known(p.z));
    const Vec3<Real> cell(floored(at.x), floored(at.y), floored(at.z));
    const Vec3<Real> way = at - cell;
    const I x = W::truncated(cell.x);
    const I y = W::truncated(cell.y);
    const I z = W::truncated(cell.z);
    const auto corner = [&](int i, int j, int k) {
        const Vec3<Real> step(Real(static_cast<float>(i)), Real(static_cast<float>(j)),
                              Real(static_cast<float>(k)));
        return lattice_slope<Real>(lattice_hash<Real>(x + I(i), y + I(j), z + I(k)), way - step);
    };
    const auto along_x = [&](int j, int k) {
        return mixed(corner(0, j, k), corner(1, j, k), fade(way.x));
    };
    const auto along_y = [&](int k) { return mixed(along_x(0, k), along_x(1, k), fade(way.y)); };
    return mixed(along_y(0), along_y(1), fade(way.z));
}

/// Sum of |noise| over finer and finer lattices, each half as strong.
template <class Real>
Real turbulence(const Vec3<Real>& p, int octaves) noexcept {
    Real sum(0);
    float size = 1;
    for (int i = 0; i < octaves; ++i, size *= 2)
        sum = sum + magnitude(noise(p * Real(size))) * Real(1 / size);
    return sum;
}

}  // namespace scanlight::shading
