#include <vector>

#include "raster/instruction_sets.h"
#include "raster/lane_path.h"

namespace scanlight::raster {

// Here, lest lanes define what all use.
SpanPainter::~SpanPainter() = default;
Walker::~Walker() = default;

SCANLIGHT_FOR_EACH_SET(SCANLIGHT_DECLARE_LANE_PATH)

namespace {

std::vector<const LanePath*> runnable_paths() {
    std::vector<const LanePath*> paths;
#define ADD_IF_RUNNABLE(set, runs) \
    if (runs) paths.push_back(&set::lane_path);
    SCANLIGHT_FOR_EACH_SET(ADD_IF_RUNNABLE)
#undef ADD_IF_RUNNABLE
    return paths;
}

}  // namespace

std::span<const LanePath* const> lane_paths() {
    static const std::vector<const LanePath*> paths = runnable_paths();
    return paths;
}

}  // namespace scanlight::raster
