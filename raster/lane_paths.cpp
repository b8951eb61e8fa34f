#include <vector>

#include "raster/lane_path.h"

#ifndef SCANLIGHT_X86_LANES
#include <hwy/highway.h>
#endif

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

#ifdef SCANLIGHT_X86_LANES

// The x86-64 levels that the top CMakeLists.txt compiles for. The compilers' own question is asked
// rather than Highway's, whose library takes five milliseconds to start.

bool runs_v2() {
    return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
}
bool runs_v3() {
    return runs_v2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
bool runs_v4() {
    return runs_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

std::vector<const LanePath*> runnable_paths() {
    std::vector<const LanePath*> paths;
    if (runs_v4()) paths.push_back(&N_AVX3::lane_path);
    if (runs_v3()) paths.push_back(&N_AVX2::lane_path);
    if (runs_v2()) paths.push_back(&N_SSE4::lane_path);
    paths.push_back(&N_EMU128::lane_path);
    return paths;
}

#else

std::vector<const LanePath*> runnable_paths() {
    return {&HWY_NAMESPACE::lane_path};
}

#endif

}  // namespace

std::span<const LanePath* const> lane_paths() {
    static const std::vector<const LanePath*> paths = runnable_paths();
    return paths;
}

}  // namespace scanlight::raster
