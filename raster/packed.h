#pragma once

#include <cstdint>

#include "raster/framebuffer.h"

namespace scanlight::raster {

/// A pixel in 32 bits, 8 a channel: red in the lowest byte, then green, blue and alpha.
using PackedPixel = std::uint32_t;

/// How intensities become bytes.
enum class Encoding {
    srgb,    // for people's eyes: IEC 61966-2-1
    linear,  // nearest of 255 equal steps
};

/// The nearest of 255 equal steps from 0 to 1; of a NaN 0.
std::uint8_t step_of_255(float value);

/// Clamped to [0, 1] first; a NaN is 0. Alpha has 255 equal steps.
PackedPixel packed_pixel(const Rgba& color, Encoding encoding);

}  // namespace scanlight::raster
