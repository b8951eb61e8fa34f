#pragma once

#include "raster/framebuffer.h"
#include "raster/image.h"
#include "raster/packed.h"

namespace scanlight::raster {

/// An image of red, green and blue, opaque.
Plane<PackedPixel> packed_image(const Image8& image);

}  // namespace scanlight::raster
