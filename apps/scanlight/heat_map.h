#pragma once

#include <cstdint>

#include "raster/framebuffer.h"
#include "raster/image.h"

namespace scanlight::apps {

/// Counts as colours: grey is 0, yellow to red more, light to dark blue less than 0; with a legend
/// in the upper right corner.
raster::Image8 heat_map(const raster::Plane<std::int32_t>& counts);

}  // namespace scanlight::apps
