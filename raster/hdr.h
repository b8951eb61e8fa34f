#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// Radiance's shared-exponent RGBE (Ward 1991, "Real Pixels", Graphics Gems II), run-length coded.
/// A pixel keeps 8 bits of its brightest channel, the others lose as much in absolute size. The
/// format has no negative and no infinite light: negative and NaN become 0, what is above its range
/// becomes its largest value, 1.69e38; below 1e-32 a pixel is black. One channel is written as
/// grey; the format holds no alpha channel.
Bytes encode_hdr(const ImageF& image);

/// Three channels, mantissa · 2^(exponent - 136). Reads flat and new run-length pixels, rows from
/// the top down (-Y +X); EXPOSURE is not applied. Throws ImageError: another layout (XYZE, old
/// run lengths), sizes past the limits, bytes missing or left over.
ImageF decode_hdr(const EncodedImage& file);

}  // namespace scanlight::raster
