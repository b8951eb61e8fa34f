#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// PNG of 8 or 16 bits, 1 to 4 channels, lossless. The same pixels decode on every machine; the
/// bytes depend on the version of zlib. Throws ImageError when memory runs out or a side is longer
/// than a million pixels.
Bytes encode_png(const Image8& image);
Bytes encode_png(const Image16& image);

/// Any PNG: palettes and fewer than 8 bits become 8 bits, a transparent colour becomes an alpha
/// channel, 16 bits stay; no colour is converted. Throws ImageError: not a PNG, damaged (a wrong
/// checksum, missing pixels), sizes past the limits.
AnyImage decode_png(const EncodedImage& file);

}  // namespace scanlight::raster
