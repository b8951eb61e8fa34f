#include "raster/instruction_sets.h"
#include "raster/lane_path.h"

namespace scanlight::raster {

// Here, lest lanes define what all use.
SpanPainter::~SpanPainter() = default;
Walker::~Walker() = default;

SCANLIGHT_DEFINE_LANE_PATHS

}  // namespace scanlight::raster
