#pragma once

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// A baseline or progressive JPEG of 8 bits a sample: grey, or YCbCr, RGB, CMYK or YCCK as RGB.
/// CMYK becomes RGB by (1 - C)(1 - K) and so on, whatever profile the file names; EXIF's
/// orientation is not followed. The same bits by each version of libjpeg-turbo and each processor:
/// the exact integer cosine transform, chroma repeated and not smoothed. Throws ImageError: not a
/// JPEG, damaged or cut off, arithmetic coding, other samples than 8 bits, sizes past the limits.
Image8 decode_jpeg(const EncodedImage& file);

}  // namespace scanlight::raster
