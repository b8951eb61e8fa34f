#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// Portable float map: Pf for one channel, PF for three, little endian, bottom row first. Every bit
/// of every float is kept. The format holds no alpha channel.
Bytes encode_pfm(const ImageF& image);

/// Reads both byte orders. The header's scale gives only the order; its size multiplies nothing.
/// Throws ImageError: not a PFM, sizes past the limits, bytes missing or left over.
ImageF decode_pfm(const EncodedImage& file);

}  // namespace scanlight::raster
