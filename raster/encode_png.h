#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// PNG of 8 or 16 bits, 1 to 4 channels, lossless. The same picture gives the same bytes wherever
/// libdeflate has the same version. Throws ImageError when there are no pixels, memory runs out or
/// a side is longer than a million pixels, which is as much as libpng reads.
///
/// See docs/decisions/0007-libdeflate-writes-png.md.
Bytes encode_png(const Image8& image);
Bytes encode_png(const Image16& image);

}  // namespace scanlight::raster
