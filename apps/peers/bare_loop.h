#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "raster/fixed.h"
#include "raster/packed.h"

namespace scanlight::peers {

/// The least that a z-buffer can do, by the widest vectors of this machine: reads z of `count`
/// pixels, compares, and writes z and colour where it is nearer. All pixels have one z and one
/// colour.
void bare_span(raster::Depth* depth, raster::PackedPixel* color, std::size_t count, raster::Depth z,
               raster::PackedPixel pixel);

/// The name of their instruction set.
std::string bare_instructions();

}  // namespace scanlight::peers
