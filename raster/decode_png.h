#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// Any PNG: palettes and fewer than 8 bits become 8 bits, a transparent colour becomes an alpha
/// channel, 16 bits stay; no colour is converted. Throws ImageError: not a PNG, damaged (a wrong
/// checksum, missing pixels), sizes past the limits.
AnyImage decode_png(const EncodedImage& file);

}  // namespace scanlight::raster
