#pragma once

#include <array>
#include <cstddef>

#include "shading/real.h"

namespace scanlight::shading {

// Logarithm and exponential to base 2 by series of our own, since no two mathematics libraries
// agree in the last bit. Each stops where the next term falls below the rounding.

/// 2/ln2 divided by 1, 3, 5, …
template <class Real>
inline constexpr auto log2_coefficients = [] {
    std::array<typename Format<Real>::Scalar, Format<Real>::log2_terms> series{};
    for (std::size_t k = 0; k < series.size(); ++k)
        series[k] = static_cast<typename Format<Real>::Scalar>(2.88539008177792681472 /
                                                               static_cast<double>(2 * k + 1));
    return series;
}();

/// 1/1!, 1/2!, 1/3!, …
template <class Real>
inline constexpr auto exp2_coefficients = [] {
    std::array<typename Format<Real>::Scalar, Format<Real>::exp2_terms> series{};
    double factorial = 1;
    for (std::size_t k = 0; k < series.size(); ++k) {
        factorial *= static_cast<double>(k + 1);
        series[k] = static_cast<typename Format<Real>::Scalar>(1 / factorial);
    }
    return series;
}();

/// log2(x) for normal x > 0, with a relative error below 5e-16 in double and 3e-7 in float.
///     log2(m) = 2/ln2 (s + s^3/3 + s^5/5 + ...), s = (m - 1)/(m + 1)
/// for the mantissa m of x, whose m - 1 is exact; |s| < 0.172. Exact for powers of two.
template <class Real>
Real log2_of(Real x) noexcept {
    const auto [mantissa, exponent] = split(x);
    const Real s = (mantissa - Real(1)) / (mantissa + Real(1));
    const Real s2 = s * s;
    Real sum(0);
    for (std::size_t k = Format<Real>::log2_terms; k-- > 0;)
        sum = sum * s2 + Real(log2_coefficients<Real>[k]);
    return exponent + s * sum;
}

/// 2^t for -126 <= t <= 126, with a relative error below 4e-16 in double and 2e-7 in float.
///     2^f = 1 + y + y^2/2! + y^3/3! + ..., y = f ln2
/// for the fraction f of t, -1/2 <= f <= 1/2. Exact for whole t.
template <class Real>
Real exp2_of(Real t) noexcept {
    constexpr double ln2 = 0.69314718055994530942;
    const Real whole = nearest_whole(t);
    const Real y = (t - whole) * Real(ln2);
    Real sum(0);
    for (std::size_t k = Format<Real>::exp2_terms; k-- > 0;)
        sum = (sum + Real(exp2_coefficients<Real>[k])) * y;
    return (Real(1) + sum) * power_of_two(whole);
}

/// e^-y for y >= 0, with a relative error below 1e-14 in double and 8e-6 in float; like a `power`
/// it is 0 below 2^-100, and where y is NaN.
template <class Real>
Real exp_of_minus(Real y) noexcept {
    const Real halvings = y * Real(1.44269504088896340736);  // 1/ln2
    const auto counts = halvings <= Real(100);
    const Real value = exp2_of(-select(counts, halvings, Real(0)));
    return select(counts, value, Real(0));
}

}  // namespace scanlight::shading
