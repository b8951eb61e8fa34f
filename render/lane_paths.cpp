#include "raster/instruction_sets.h"
#include "render/lane_path.h"

namespace scanlight::render {

SCANLIGHT_DEFINE_LANE_PATHS

}  // namespace scanlight::render
