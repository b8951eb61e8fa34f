#include "raster/packed.h"

#include <cmath>

#include "raster/srgb.h"

namespace scanlight::raster {

namespace {

PackedPixel byte_of(float intensity, Encoding encoding) {
    if (encoding == Encoding::srgb) return srgb_from_linear(intensity);
    return static_cast<PackedPixel>(std::lrint(clamped(intensity, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

PackedPixel packed_pixel(const Rgba& color, Encoding encoding) {
    const PackedPixel alpha = byte_of(color.a, Encoding::linear);
    return byte_of(color.r, encoding) | byte_of(color.g, encoding) << 8 |
           byte_of(color.b, encoding) << 16 | alpha << 24;
}

}  // namespace scanlight::raster
