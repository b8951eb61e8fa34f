#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scanlight::raster {

// The number formats of the rasterizer. Coverage is exact integer arithmetic. Increments are
// rounded to integers once, and from there on added exactly: repeated addition, direct evaluation
// and any number of lanes give the same bits.

/// Screen coordinate in 1/256 pixel. Pixel (i, j) has its centre at (256 i + 128, 256 j + 128).
using SubPixel = std::int32_t;
inline constexpr int subpixel_bits = 8;
inline constexpr SubPixel subpixels = 1 << subpixel_bits;
inline constexpr SubPixel half_pixel = subpixels / 2;

/// Largest width and height of a picture, in pixels.
inline constexpr int max_size = 16384;

/// Depth in 30 bits: 0 at the near plane, `depth_far` at the far plane, smaller is nearer.
using Depth = std::int32_t;
inline constexpr Depth depth_far = (1 << 30) - 1;
/// Behind everything. Its bytes are alike, so that memory is filled as fast as it can be.
inline constexpr Depth depth_clear = 0x40404040;

/// An interpolated number in 2.29 fixed point, range [-4, 4): a colour channel, a component of a
/// normal, or the perspective factor q.
using Attribute = std::int32_t;
inline constexpr float attribute_one = 536870912.0f;  // 2^29

/// The largest attribute of a corner. What is interpolated over the largest picture may be off by
/// 17409 units (see `attribute_plane`): with 32768 units left to the ends of the format it never
/// wraps round into the other sign.
inline constexpr float attribute_limit = 4.0f - 0x1p-14f;

/// Extra fraction bits that an interpolated number carries while it is stepped.
inline constexpr int ramp_bits = 16;

/// A quotient rounded down, and what remains: in [0, divisor).
struct Quotient {
    std::int32_t whole;
    std::int32_t remainder;
};

/// Requires b > 0, and a quotient that fits.
template <class T>
constexpr Quotient floor_divided(T a, std::int32_t b) {
    const auto whole = static_cast<std::int32_t>(a / b);
    const auto remainder = static_cast<std::int32_t>(a % b);
    const std::int32_t below = remainder >> 31;  // -1 or 0
    return {whole + below, remainder + (b & below)};
}

/// The first row (or column) whose centre is at or after `coordinate`.
constexpr int first_centre(SubPixel coordinate) {
    return (coordinate + half_pixel - 1) >> subpixel_bits;
}

// Conversions clamp before they convert: what an out-of-range cast gives differs between machines.
// A NaN becomes `low`.
inline float clamped(float value, float low, float high) {
    return std::min(high, std::max(low, value));
}

/// How far beyond the far plane depth can tell, for what is not clipped there.
inline constexpr float deepest_ndc = 1.5f;
/// Beyond that.
inline constexpr Depth depth_beyond = 0x7fffffff;

inline Depth depth_from_ndc(float z, float deepest = 1.0f) {
    return static_cast<Depth>(
        std::llrint(static_cast<double>(clamped(z, 0.0f, deepest)) * depth_far));
}

/// The far plane's depth, as a float, is 2^30.
inline constexpr float ndc_a_depth = 1.0f / 1073741824.0f;

inline float ndc_from_depth(Depth depth) {
    return static_cast<float>(depth) * ndc_a_depth;
}

inline Attribute attribute_from_float(float value) {
    return static_cast<Attribute>(
        std::lrint(clamped(value, -attribute_limit, attribute_limit) * attribute_one));
}

inline float float_from_attribute(Attribute value) {
    return static_cast<float>(value) * (1.0f / attribute_one);
}

}  // namespace scanlight::raster
