#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace scanlight::shading {

// This room's functions are templates on the number type `Real`: float on the way to a pixel,
// double where precision is examined, a vector of float lanes where many pixels are lit at once.
// Beyond + - * /, comparisons and & of their results, a number type brings what this file gives
// float and double; a vector type overloads the same names beside itself. Only correctly rounded
// operations are used, each in one written order, so that every number type, compiler and machine
// gives the same bits.

/// `yes` where `condition` holds, else `no`. Both are evaluated, as in a vector.
template <std::floating_point Real>
constexpr Real select(bool condition, Real yes, Real no) noexcept {
    return condition ? yes : no;
}

/// Whether nobody has it: what would be done for none may be left out.
constexpr bool none(bool condition) noexcept {
    return !condition;
}

/// Correctly rounded, unlike the rest of `<cmath>`.
template <class Real>
Real square_root(Real x) noexcept {
    using std::sqrt;
    return sqrt(x);
}

/// x+ = max(0, x). NaN gives 0.
template <class Real>
constexpr Real positive_part(Real x) noexcept {
    return select(x > Real(0), x, Real(0));
}

/// The layout of an IEEE 754 number, and how many terms of a series reach its precision. `Scalar`
/// is the number itself, or one lane of a vector.
template <class Real>
struct Format;

template <>
struct Format<float> {
    using Scalar = float;
    using Integer = std::int32_t;
    static constexpr int fraction_bits = 23;
    static constexpr Integer bias = 127;
    static constexpr std::size_t log2_terms = 5;
    static constexpr std::size_t exp2_terms = 7;
    static constexpr std::size_t sine_terms = 7;
    static constexpr std::size_t arctangent_terms = 9;
    static constexpr std::size_t squared_angle_terms = 8;
};

template <>
struct Format<double> {
    using Scalar = double;
    using Integer = std::int64_t;
    static constexpr int fraction_bits = 52;
    static constexpr Integer bias = 1023;
    static constexpr std::size_t log2_terms = 10;
    static constexpr std::size_t exp2_terms = 13;
    static constexpr std::size_t sine_terms = 11;
    static constexpr std::size_t arctangent_terms = 20;
    static constexpr std::size_t squared_angle_terms = 18;
};

/// x = mantissa * 2^exponent, with the mantissa in [sqrt(1/2), sqrt(2)).
template <class Real>
struct Split {
    Real mantissa;
    Real exponent;
};

/// Splits a positive normal number. The mantissa is centred on 1, so that the exponent of a number
/// just below 1 is 0 and its logarithm keeps all its digits.
template <std::floating_point Real>
Split<Real> split(Real x) noexcept {
    using Integer = typename Format<Real>::Integer;
    constexpr int fraction_bits = Format<Real>::fraction_bits;
    constexpr auto lowest = std::bit_cast<Integer>(static_cast<Real>(0.70710678118654752440));
    const auto bits = std::bit_cast<Integer>(x);
    const Integer exponent = (bits - lowest) >> fraction_bits;
    return {std::bit_cast<Real>(bits - (exponent << fraction_bits)), static_cast<Real>(exponent)};
}

/// The whole number nearest to x, to even in a tie, for |x| < 2^22: beside a number whose last bit
/// is one there is no room for a fraction.
template <std::floating_point Real>
Real nearest_whole(Real x) noexcept {
    constexpr auto last_bit_is_one = static_cast<Real>(3LL << (Format<Real>::fraction_bits - 1));
    return (x + last_bit_is_one) - last_bit_is_one;
}

/// The greatest whole number not above x.
template <class Real>
Real floored(Real x) noexcept {
    using std::floor;
    return floor(x);
}

/// 2^exponent, for whole exponents from -126 to 127.
template <std::floating_point Real>
Real power_of_two(Real exponent) noexcept {
    using Integer = typename Format<Real>::Integer;
    const Integer biased = static_cast<Integer>(exponent) + Format<Real>::bias;
    return std::bit_cast<Real>(biased << Format<Real>::fraction_bits);
}

}  // namespace scanlight::shading
