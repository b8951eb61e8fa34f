#pragma once

#include <bit>
#include <cstdint>

#include "shading/base2.h"
#include "shading/exponent.h"

namespace scanlight::shading {

/// x^n by repeated squaring from the highest bit of n down (Knuth, "The Art of Computer
/// Programming" 2, 4.6.3, "left-to-right binary"): every number on the way is an x^j with j <= n,
/// and rounding keeps the order of the x.
template <class Real>
Real whole_power(Real x, std::uint32_t n) noexcept {
    if (n == 0) return Real(1);
    Real power = x;
    for (std::uint32_t bit = std::bit_floor(n) >> 1; bit != 0; bit >>= 1) {
        power = power * power;
        if ((n & bit) != 0) power = power * x;
    }
    return power;
}

/// x^n = 2^(n log2 x), for x in [2^-126, 1] and x^n >= 2^-126.
template <class Real>
Real real_power(Real x, Real n) noexcept {
    return exp2_of(n * log2_of(x));
}

/// x^n for x in [0, 1], and for any x: more than 1 counts as 1, less than 0 and NaN give 0.
/// A power below 2^-100, and one of x below 2^-126, is 0; x^0 = 1. Never NaN or denormal.
/// Relative error: for whole n up to 65536 below n u, with u = 2^-24 in float and 2^-53 in double,
/// and the result never decreases in x. For any other n it is below 1e-6 in float and 2e-15 in
/// double where the power is above 1/8, and below 3e-5 and 5e-14 all the way down to 2^-100.
/// + - * / only, in one order: the same bits on every machine.
template <class Real>
Real power(Real x, const Exponent& n) noexcept {
    const auto counts = x >= Real(n.least_base());
    const Real base = select(counts, select(x < Real(1), x, Real(1)), Real(1));
    const Real value =
        n.is_whole() ? whole_power(base, n.whole()) : real_power(base, Real(n.value()));
    return select(counts, value, Real(0));
}

/// An n that differs from place to place, 0 to 2^24.
template <class Real>
struct VaryingExponent {
    Real value;
};

/// x^n, as for an `Exponent` that is no whole number; the same limits.
template <class Real>
Real power(Real x, const VaryingExponent<Real>& n) noexcept {
    const auto counts = x >= Real(0x1p-126f);
    const Real base = select(counts, select(x < Real(1), x, Real(1)), Real(1));
    const Real t = n.value * log2_of(base);
    const auto is_large = t >= Real(-100);
    const Real value = select(is_large, exp2_of(select(is_large, t, Real(0))), Real(0));
    return select(counts, value, select(n.value > Real(0), Real(0), Real(1)));
}

}  // namespace scanlight::shading
