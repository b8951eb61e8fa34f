#pragma once

#include <string>

#include "raster/encoded_image.h"
#include "raster/image.h"

namespace scanlight::raster {

/// The picture in the bytes of a PNG, JPEG, binary PPM or PGM, PFM or Radiance HDR file, told apart
/// by how they begin. Throws ImageError "name: reason": not one of these, damaged, wider or higher
/// than 16384 pixels, or larger than 256 MiB, which is known before memory is taken.
AnyImage decode_image(const EncodedImage& file);

/// Reads an image file; "-" is standard input. Throws ImageError as decode_image does, and when the
/// file can't be read.
AnyImage load_image(const std::string& path);

}  // namespace scanlight::raster
