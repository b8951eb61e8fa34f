#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <type_traits>

#include "shading/vector.h"

namespace scanlight::shading {

/// Relative tolerance of the oracles, which are given to nine digits; in float it covers the
/// rounding of the inputs, magnified by the exponents (up to 200).
template <class Real>
inline constexpr double tolerance = std::is_same_v<Real, double> ? 1e-6 : 5e-5;

/// Runs a check in double and, at its own tolerance, in float:
///     in_both_precisions([]<class Real>() { … });
template <class Check>
void in_both_precisions(Check check) {
    {
        SCOPED_TRACE("double");
        check.template operator()<double>();
    }
    SCOPED_TRACE("float");
    check.template operator()<float>();
}

/// Relative, except that of an expected 0 the tolerance is absolute.
template <std::floating_point Real>
void expect_value(Real actual, double expected) {
    const double scale = expected == 0 ? 1 : std::abs(expected);
    EXPECT_NEAR(static_cast<double>(actual), expected, tolerance<Real> * scale);
}

template <class Real>
void expect_value(const Vec3<Real>& actual, const Vec3<double>& expected) {
    expect_value(actual.x, expected.x);
    expect_value(actual.y, expected.y);
    expect_value(actual.z, expected.z);
}

/// The unit vector along (x, y, z).
template <class Real>
Vec3<Real> along(double x, double y, double z) {
    return unit(Vec3<Real>(Vec3<double>(x, y, z)));
}

inline double radians(double degrees) {
    return degrees * 3.14159265358979323846 / 180;
}

template <class Real>
Real cos_deg(double degrees) {
    return static_cast<Real>(std::cos(radians(degrees)));
}

}  // namespace scanlight::shading
