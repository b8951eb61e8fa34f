#pragma once

#include <array>
#include <cstddef>

#include "shading/whole.h"

namespace scanlight::shading {

// Angles, by series of our own (see base2.h). A turn is 2 pi radians.

inline constexpr double pi = 3.14159265358979323846;

/// 1, -1/3!, 1/5!, …: sin(y) = y (1 - y^2/3! + …).
template <class Real>
inline constexpr auto sine_coefficients = [] {
    std::array<typename Format<Real>::Scalar, Format<Real>::sine_terms> series{};
    double term = 1;
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k] = static_cast<typename Format<Real>::Scalar>(term);
        term /= -static_cast<double>((2 * k + 2) * (2 * k + 3));
    }
    return series;
}();

/// 1, -1/3, 1/5, …: arctan(t) = t (1 - t^2/3 + …).
template <class Real>
inline constexpr auto arctangent_coefficients = [] {
    std::array<typename Format<Real>::Scalar, Format<Real>::arctangent_terms> series{};
    for (std::size_t k = 0; k < series.size(); ++k)
        series[k] = static_cast<typename Format<Real>::Scalar>((k % 2 == 0 ? 1.0 : -1.0) /
                                                               static_cast<double>(2 * k + 1));
    return series;
}();

template <class Real, class Series>
Real odd_series(const Series& coefficients, Real x) noexcept {
    const Real x2 = x * x;
    Real sum(0);
    for (std::size_t k = coefficients.size(); k-- > 0;)
        sum = sum * x2 + Real(coefficients[k]);
    return x * sum;
}

/// sin of so many turns, |t| < 2^31; off by less than 2e-7 in float where t itself is exact.
template <class Real>
Real sine_of_turns(Real t) noexcept {
    const Real r = t - floored(t + Real(0.5));  // -1/2 to 1/2
    const Real beyond = select(r < Real(0), Real(-0.5), Real(0.5)) - r;
    const Real folded = select((r > Real(0.25)) | (r < Real(-0.25)), beyond, r);
    return odd_series(sine_coefficients<Real>, folded * Real(2 * pi));
}

template <class Real>
Real cosine_of_turns(Real t) noexcept {
    return sine_of_turns(t + Real(0.25));
}

/// arctan(t) in turns, for t from 0 to 1: between 0 and 1/8.
template <class Real>
Real arctangent_turns(Real t) noexcept {
    constexpr double tan_of_a_sixteenth = 0.41421356237309504880;
    const auto large = t > Real(tan_of_a_sixteenth);
    const Real reduced = select(large, (t - Real(1)) / (t + Real(1)), t);
    const Real turns = odd_series(arctangent_coefficients<Real>, reduced) * Real(0.5 / pi);
    return select(large, Real(0.125) + turns, turns);
}

template <class Real>
Real magnitude(Real x) noexcept {
    return select(x < Real(0), -x, x);
}

/// The direction of (x, y) in turns from the x axis, from -1/2 to 1/2; 0 for no direction. Off by
/// less than 1e-7 in float.
template <class Real>
Real turns_towards(Real y, Real x) noexcept {
    const Real ax = magnitude(x);
    const Real ay = magnitude(y);
    const auto steep = ay > ax;
    const Real larger = select(steep, ay, ax);
    const Real smaller = select(steep, ax, ay);
    const Real octant = arctangent_turns(smaller / select(larger > Real(0), larger, Real(1)));
    const Real quadrant = select(steep, Real(0.25) - octant, octant);
    const Real half = select(x < Real(0), Real(0.5) - quadrant, quadrant);
    return select(y < Real(0), -half, half);
}

}  // namespace scanlight::shading
