#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// Netpbm's binary PGM (P5) for one channel, PPM (P6) for three, maxval 255 or 65535 (big endian).
/// The format holds no alpha channel.
Bytes encode_pnm(const Image8& image);
Bytes encode_pnm(const Image16& image);

/// The one picture of a P5 or P6 file; comments in the header are skipped. Throws ImageError: other
/// kinds, another maxval than 255 or 65535, sizes past the limits, bytes missing or left over.
AnyImage decode_pnm(const EncodedImage& file);

}  // namespace scanlight::raster
