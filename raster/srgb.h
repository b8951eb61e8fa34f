#pragma once

#include <array>
#include <cstdint>

namespace scanlight::raster {

/// The 8-bit sRGB value of a linear intensity, IEC 61966-2-1:1999:
///     255 · (12.92 x           where x <= 0.0031308,
///            1.055 x^(1/2.4) - 0.055 elsewhere), rounded to nearest.
/// Correctly rounded for every float, never falling as x grows, the same on every machine. Below 0
/// and NaN give 0, above 1 gives 255.
std::uint8_t srgb_from_linear(float linear) noexcept;

/// The inverse, in [0, 1], correctly rounded to float.
float linear_from_srgb(std::uint8_t srgb) noexcept;

/// The same for vectors of intensities. Those of [2^-13, 1) fall into cells by exponent and the
/// first seven bits of the fraction. A cell's entry holds the byte of its first intensity, shifted
/// left by 17, and below that the last 16 bits from which on the byte is one more, or 65536.
inline constexpr float first_srgb_cell = 1.0f / 8192;
extern const std::array<std::int32_t, 13 * 128> srgb_cells;

}  // namespace scanlight::raster
