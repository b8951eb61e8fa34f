#include "raster/packed.h"

#include <cmath>

#include "raster/srgb.h"

namespace scanlight::raster {

namespace {

PackedPixel byte_of(float intensity, Encoding encoding) {
    if (encoding == Encoding::srgb) return srgb_from_linear(intensity);
    return step_of_255(intensity);
}

}  // namespace

std::uint8_t step_of_255(float value) {
    return static_cast<std::uint8_t>(std::lrint(clamped(value, 0.0f, 1.0f) * 255.0f));
}

PackedPixel packed_pixel(const Rgba& color, Encoding encoding) {
    const PackedPixel alpha = step_of_255(color.a);
    return byte_of(color.r, encoding) | byte_of(color.g, encoding) << 8 |
           byte_of(color.b, encoding) << 16 | alpha << 24;
}

}  // namespace scanlight::raster
