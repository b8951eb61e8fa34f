#pragma once

#include <span>

#include "raster/framebuffer.h"

namespace scanlight::raster {

/// A row of pixels, each the mean of a square of samples: a box filter, in linear light. The
/// squares stand side by side in the rows from `first_row` on, as wide as fit as many as there are
/// pixels. Alpha is the mean too, and the weight of a sample's colour: nothing has none. Samples
/// are added row by row, from left to right.
void average_rows(const Plane<Rgba>& samples, int first_row, std::span<Rgba> pixels);

}  // namespace scanlight::raster
