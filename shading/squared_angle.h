#pragma once

#include <array>
#include <cstddef>

#include "shading/real.h"

namespace scanlight::shading {

/// 2 2^n/(n^2 (2n)!/(n!)^2): 2, 1/3, 4/45, 1/35, …
template <class Real>
inline constexpr auto squared_angle_coefficients = [] {
    std::array<typename Format<Real>::Scalar, Format<Real>::squared_angle_terms> series{};
    double choices = 2;  // (2n)!/(n!)^2
    double power = 2;    // 2^n
    for (std::size_t k = 0; k < series.size(); ++k) {
        const auto n = static_cast<double>(k + 1);
        series[k] = static_cast<typename Format<Real>::Scalar>(2 * power / ((n * n) * choices));
        choices *= 2 * (2 * n + 1) / (n + 1);
        power *= 2;
    }
    return series;
}();

/// The square of the angle whose cosine is c, arccos(c)^2, for c in [0, 1]; more than 1 counts as
/// 1. Relative error below 5e-16 in double and 3e-7 in float.
///     arccos(1 - x)^2 = 2 x + x^2/3 + 4 x^3/45 + …
/// The angle itself has no tangent at c = 1, where highlights are; its square has, and 1 - c is
/// exact. The series is taken of half the angle, whose cosine is sqrt((1 + c)/2), so that
/// x < 0.293.
template <class Real>
Real squared_angle(Real c) noexcept {
    const Real half_off = positive_part(Real(1) - c) * Real(0.5);  // sin^2 of half the angle
    const Real x = half_off / (Real(1) + square_root(Real(1) - half_off));
    Real sum(0);
    for (std::size_t k = Format<Real>::squared_angle_terms; k-- > 0;)
        sum = sum * x + Real(squared_angle_coefficients<Real>[k]);
    return Real(4) * (x * sum);
}

}  // namespace scanlight::shading
