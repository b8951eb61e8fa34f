#include <algorithm>
#include <vector>

#include "raster/instruction_sets.h"
#include "render/lane_path.h"

namespace scanlight::render {

SCANLIGHT_FOR_EACH_SET(SCANLIGHT_DECLARE_LANE_PATH)

namespace {

std::vector<const LanePath*> runnable_paths() {
    const auto runnable = raster::lane_paths();
    std::vector<const LanePath*> paths;
#define ADD(set, runs) paths.push_back(&set::lane_path);
    SCANLIGHT_FOR_EACH_SET(ADD)
#undef ADD
    std::erase_if(paths, [&](const LanePath* path) {
        return std::ranges::find(runnable, path->raster) == runnable.end();
    });
    return paths;
}

}  // namespace

std::span<const LanePath* const> lane_paths() {
    static const std::vector<const LanePath*> paths = runnable_paths();
    return paths;
}

}  // namespace scanlight::render
