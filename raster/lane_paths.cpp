#include <hwy/highway.h>
#include <hwy/targets.h>

#include <vector>

#include "raster/lane_path.h"

namespace scanlight::raster {

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
    const auto supported = hwy::SupportedTargets();
    std::vector<const LanePath*> paths;
    if ((supported & HWY_AVX3) != 0) paths.push_back(&N_AVX3::lane_path);
    if ((supported & HWY_AVX2) != 0) paths.push_back(&N_AVX2::lane_path);
    if ((supported & HWY_SSE4) != 0) paths.push_back(&N_SSE4::lane_path);
    paths.push_back(&N_EMU128::lane_path);
    return paths;
#else
    return {&HWY_NAMESPACE::lane_path};
#endif
}

}  // namespace

std::span<const LanePath* const> lane_paths() {
    static const std::vector<const LanePath*> paths = runnable_paths();
    return paths;
}

}  // namespace scanlight::raster
