#pragma once

#include <vector>

#include "raster/lanes/numbers.h"
#include "render/lane_path.h"
#include "render/lanes/store.h"

namespace scanlight::render::HWY_NAMESPACE {

// Light that waited until it was known what is seen. Lit by what the pixels keep.

/// The colours of all pixels of a row that show one of the pass's faces; how many there are.
std::size_t light_row(const ObjectPass& pass, raster::VisibleBand& band, const ShadowBand* shadows,
                      int y, RowWriter& to);

/// The opacity of all those pixels.
void find_row_opacity(const ObjectPass& pass, raster::VisibleBand& band, int y,
                      std::vector<float>& row);

}  // namespace scanlight::render::HWY_NAMESPACE
