#include <vector>

#include "render/lane_path.h"

#ifndef SCANLIGHT_X86_LANES
#include <hwy/highway.h>
#endif

namespace scanlight::render {

#ifdef SCANLIGHT_X86_LANES
namespace N_EMU128 {
extern const LanePath lane_path;
}
namespace N_SSE4 {
extern const LanePath lane_path;
}
namespace N_AVX2 {
extern const LanePath lane_path;
}
namespace N_AVX3 {
extern const LanePath lane_path;
}
#else
namespace HWY_NAMESPACE {
extern const LanePath lane_path;
}
#endif

namespace {

std::vector<const LanePath*> runnable_paths() {
#ifdef SCANLIGHT_X86_LANES
    const LanePath* const known[] = {&N_AVX3::lane_path, &N_AVX2::lane_path, &N_SSE4::lane_path,
                                     &N_EMU128::lane_path};
#else
    const LanePath* const known[] = {&HWY_NAMESPACE::lane_path};
#endif
    std::vector<const LanePath*> paths;
    for (const raster::LanePath* runnable : raster::lane_paths()) {
        for (const LanePath* path : known) {
            if (path->raster == runnable) paths.push_back(path);
        }
    }
    return paths;
}

}  // namespace

std::span<const LanePath* const> lane_paths() {
    static const std::vector<const LanePath*> paths = runnable_paths();
    return paths;
}

}  // namespace scanlight::render
