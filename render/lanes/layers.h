#pragma once

#include <cstdint>
#include <span>

#include "raster/lanes/numbers.h"
#include "render/lane_path.h"

namespace scanlight::render::HWY_NAMESPACE {

// See `LanePath`.

void see_behind(const ObjectPass& pass, std::span<const raster::FaceItem> items,
                raster::VisibleBand& band, raster::Walker& walker);

void light_layer_row(const ObjectPass& pass, raster::VisibleBand& band, const ShadowBand* shadows,
                     int y, LayerRow& row);

}  // namespace scanlight::render::HWY_NAMESPACE
