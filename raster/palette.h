#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/image.h"

namespace scanlight::raster {

/// A picture in at most 256 colours of its own.
struct PalettePicture {
    std::vector<std::array<std::uint8_t, 3>> colors;
    std::vector<std::uint8_t> pixels;  // numbers of colours, row by row
};

/// Chooses the colours by median cut (Heckbert 1982): the box of colours with the most pixels times
/// its longest side is cut at the median, until there are 256; each becomes its pixels' mean.
/// Colours are told apart by their 6 highest bits a channel; all in integers.
PalettePicture with_palette(const Image8& rgb);

}  // namespace scanlight::raster
