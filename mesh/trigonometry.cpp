#include "mesh/trigonometry.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace scanlight::mesh {
namespace {

/// An angle as `quarters` right angles and a rest in [-pi/4, pi/4].
struct Reduced {
    std::int64_t quarters;
    double rest;
};

/// Cody & Waite 1980, "Software Manual for the Elementary Functions": pi/2 in three pieces, the
/// first two of 33 bits, so that their products with up to 20 bits of quarters are exact.
Reduced reduced(double x) {
    constexpr double first = 0x1.921fb544p+0;
    constexpr double second = 0x1.0b4611a6p-34;
    constexpr double third = 0x1.3198a2e037073p-69;
    assert(x >= -1e6 && x <= 1e6);
    const double turns = x * (2.0 / pi);
    const auto quarters = static_cast<std::int64_t>(turns + (turns < 0.0 ? -0.5 : 0.5));
    const auto k = static_cast<double>(quarters);
    return {quarters, ((x - k * first) - k * second) - k * third};
}

/// The polynomial with these coefficients, lowest first, by Horner's rule.
template <std::size_t n>
double polynomial(const std::array<double, n>& coefficients, double x) {
    double sum = 0.0;
    for (std::size_t i = n; i-- > 0;) {
        sum = sum * x + coefficients[i];
    }
    return sum;
}

/// Taylor's series; the first term left out is below 5e-20 for |x| <= pi/4.
double sine_near_zero(double x) {
    static constexpr std::array series{
        -1.0 / 6,        1.0 / 120,        -1.0 / 5040,         1.0 / 362880,
        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368e3, 1.0 / 355687428096e3};
    const double square = x * x;
    return x + x * square * polynomial(series, square);
}

/// Taylor's series; the first term left out is below 3e-18 for |x| <= pi/4.
double cosine_near_zero(double x) {
    static constexpr std::array series{-1.0 / 2,           1.0 / 24,           -1.0 / 720,
                                       1.0 / 40320,        -1.0 / 3628800,     1.0 / 479001600,
                                       -1.0 / 87178291200, 1.0 / 20922789888e3};
    const double square = x * x;
    return 1.0 + square * polynomial(series, square);
}

/// tan of half the angle whose tangent is t >= 0.
double half_angle(double t) {
    return t / (1.0 + std::sqrt(1.0 + t * t));
}

/// The angle in [0, pi/4] whose tangent is t, in [0, 1]: two halvings, then Taylor's series up to
/// 0.2; the first term left out is below 4e-18.
double arc_tangent(double t) {
    static constexpr std::array series{1.0,      -1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9, -1.0 / 11,
                                       1.0 / 13, -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21};
    const double quarter = half_angle(half_angle(t));
    return 4.0 * quarter * polynomial(series, quarter * quarter);
}

/// The angle of (x, y) in the first quadrant, x and y not negative.
double angle_in_first_quadrant(double y, double x) {
    if (y == 0.0) return 0.0;
    return y <= x ? arc_tangent(y / x) : pi / 2 - arc_tangent(x / y);
}

}  // namespace

double sine(double x) {
    const Reduced angle = reduced(x);
    switch (angle.quarters & 3) {
        case 0:
            return sine_near_zero(angle.rest);
        case 1:
            return cosine_near_zero(angle.rest);
        case 2:
            return -sine_near_zero(angle.rest);
        default:
            return -cosine_near_zero(angle.rest);
    }
}

double cosine(double x) {
    const Reduced angle = reduced(x);
    switch (angle.quarters & 3) {
        case 0:
            return cosine_near_zero(angle.rest);
        case 1:
            return -sine_near_zero(angle.rest);
        case 2:
            return -cosine_near_zero(angle.rest);
        default:
            return sine_near_zero(angle.rest);
    }
}

double tangent(double x) {
    return sine(x) / cosine(x);
}

double angle_of(double y, double x) {
    const double acute = angle_in_first_quadrant(std::abs(y), std::abs(x));
    if (y >= 0.0) return x >= 0.0 ? acute : pi - acute;
    return x < 0.0 ? pi + acute : 2 * pi - acute;
}

}  // namespace scanlight::mesh
