#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "raster/ramp.h"

namespace scanlight::raster {

// Whole numbers held in doubles: exact up to 2^53, as integers are, and quickly multiplied by
// fractions. 1.5 * 2^52 plus a number has no bits left for a fraction, so that the addition rounds
// it, to nearest, ties to even; and its lowest bits are the whole number's.
inline constexpr double no_fraction = 0x1.8p52;

/// Rounded. Of 2^51 and more this is only near: some of the number's own lowest bits are lost.
inline double nearest_whole(double x) {
    return (x + no_fraction) - no_fraction;
}

/// `whole` plus the rounded `x`: each of them, and their sum, below 2^51 in absolute value.
inline std::int64_t plus_nearest(double whole, double x) {
    return std::bit_cast<std::int64_t>((x + no_fraction) + whole) -
           std::bit_cast<std::int64_t>(no_fraction);
}

/// What runs down an edge: numbers in a ramp's format, so whole multiples of 2^-16, and their steps
/// from scanline to scanline. Additions are exact. Structure of arrays, for compilers to vectorize.
template <int N>
struct EdgeRamps {
    std::array<double, N> attributes{};
    std::array<double, N> attribute_steps{};
    double depth = 0.0;
    double depth_step = 0.0;

    void step() { step(1); }
    void step(int times) {
        for (std::size_t k = 0; k < N; ++k)
            attributes[k] += times * attribute_steps[k];
        depth += times * depth_step;
    }
};

}  // namespace scanlight::raster
