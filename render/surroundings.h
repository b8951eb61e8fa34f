#pragma once

#include "raster/framebuffer.h"
#include "render/frame.h"

namespace scanlight::render {

/// What a pixel shows where no surface is: the environment, in the direction of its line of sight.
raster::Rgba surroundings_at(const Frame& frame, int x, int y);

}  // namespace scanlight::render
