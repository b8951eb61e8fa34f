#pragma once

#include "raster/image.h"

namespace scanlight::render {

/// Which number of a pixel is wanted: its luminance, which needs all of the colour, or one channel.
enum class ImageChannel { luminance, red, green, blue, alpha };

/// The channel alone, as a grey picture. All of the picture for its luminance, and for the alpha of
/// one that has none.
raster::AnyImage channel_of(const raster::AnyImage& image, ImageChannel channel);

}  // namespace scanlight::render
