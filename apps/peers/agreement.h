#pragma once

#include <cstddef>

#include "raster/framebuffer.h"
#include "raster/packed.h"

namespace scanlight::peers {

/// How two pictures of the same thing compare. What is covered has an alpha of 255.
struct Agreement {
    std::size_t covered = 0;      // in both
    std::size_t only_one = 0;     // covered in one of them
    std::size_t outline = 0;      // covered in the first, beside a pixel that is not
    double color_difference = 0;  // mean over what both cover and over the channels, in 1/255
};

Agreement agreement(const raster::Plane<raster::PackedPixel>& a,
                    const raster::Plane<raster::PackedPixel>& b);

/// Whether two renderers that snap vertices to 1/256 pixel, each after roundings of its own, may
/// differ like that: along the outline a pixel's centre in 256 may lie between the two.
bool agrees(const Agreement& agreement);

}  // namespace scanlight::peers
