#pragma once

#include "raster/framebuffer.h"
#include "raster/image.h"

namespace scanlight::raster {

enum class Alpha { dropped, kept };

/// The framebuffer's colours as they are, linear and unclamped: 3 channels, or 4 with alpha.
ImageF linear_image(const Plane<Rgba>& color, Alpha alpha);

/// The colours as a screen wants them: clamped to [0, 1] and sRGB-encoded; alpha is not encoded.
Image8 srgb_image(const Plane<Rgba>& color, Alpha alpha);

/// The 16 highest bits of depth: 0 at the near plane, 65535 where nothing is.
Image16 depth_image(const Plane<Depth>& depth);

}  // namespace scanlight::raster
