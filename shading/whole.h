#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include "shading/real.h"

namespace scanlight::shading {

// Whole numbers beside a number type: to count texels by, and to hash. A vector type specializes
// `Wholes` beside itself.

template <class Real>
struct Wholes;

template <std::floating_point Real>
struct Wholes<Real> {
    using Type = std::int32_t;

    /// Towards 0; |x| < 2^31.
    static Type truncated(Real x) noexcept { return static_cast<Type>(x); }
    static Real real(Type whole) noexcept { return static_cast<Real>(whole); }
    static Type fetched(const std::int32_t* from, Type index) noexcept { return from[index]; }
    /// from[2 index] and the one behind it.
    struct Two {
        Type first, second;
    };
    static Two fetched_two(const std::int32_t* from, Type index) noexcept {
        return {from[2 * index], from[2 * index + 1]};
    }
    /// As bits: what leaves at one end is lost, and zeros come in at the other.
    static Type shifted_left(Type bits, int by) noexcept {
        return static_cast<Type>(static_cast<std::uint32_t>(bits) << by);
    }
    static Type shifted_right(Type bits, int by) noexcept {
        return static_cast<Type>(static_cast<std::uint32_t>(bits) >> by);
    }
    /// As a number: the sign comes in, instead of zeros.
    static Type divided_by_power(Type number, int by) noexcept { return number >> by; }
    /// Modulo 2^32.
    static Type sum(Type a, Type b) noexcept {
        return static_cast<Type>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
    }
    static Type product(Type a, Type b) noexcept {
        return static_cast<Type>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
    }
    /// Of two signed 16-bit numbers in each: that of the low ones plus that of the high ones.
    static Type sum_of_products(Type a, Type b) noexcept {
        const auto low = [](Type word) { return static_cast<std::int16_t>(word & 0xffff); };
        return low(a) * low(b) + (a >> 16) * (b >> 16);
    }
    /// The number whose IEEE 754 bits, as a float, these are.
    static Real real_of_float_bits(Type bits) noexcept {
        return static_cast<Real>(std::bit_cast<float>(bits));
    }
};

/// 32-bit integers, as many as a Real has numbers; with & and |, comparisons and `select`.
template <class Real>
using Whole = typename Wholes<Real>::Type;

inline std::int32_t select(bool condition, std::int32_t yes, std::int32_t no) noexcept {
    return condition ? yes : no;
}

/// x - floored(x): in [0, 1), or 1 where x is so little below a whole number that it rounds.
template <class Real>
Real fraction(Real x) noexcept {
    return x - floored(x);
}

}  // namespace scanlight::shading
