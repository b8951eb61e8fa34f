#pragma once

#include <span>
#include <vector>

// The instruction sets for which the sources in the folders named `lanes` are compiled, each in a
// namespace of its own; see `scanlight_lanes` in the top CMakeLists.txt. The fastest comes first,
// each with the question whether this machine runs it: the compilers' own rather than that of
// Highway, whose library takes five milliseconds to start.

#ifdef SCANLIGHT_X86_LANES

#ifdef SCANLIGHT_TWO_SETS
#define SCANLIGHT_FOR_EACH_SET(USE) USE(N_AVX3, raster::runs_v4()) USE(N_SSE4, true)
#else
#define SCANLIGHT_FOR_EACH_SET(USE) \
    USE(N_AVX3, raster::runs_v4())  \
    USE(N_AVX2, raster::runs_v3())  \
    USE(N_SSE4, raster::runs_v2())  \
    USE(N_EMU128, true)
#endif

namespace scanlight::raster {

// The levels of x86-64 that the compilers call -v2, -v3 and -v4.

inline bool runs_v2() {
    return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
}
inline bool runs_v3() {
    return runs_v2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
inline bool runs_v4() {
    return runs_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

}  // namespace scanlight::raster

#else

#include <hwy/highway.h>

#define SCANLIGHT_FOR_EACH_SET(USE) USE(HWY_NAMESPACE, true)

#endif

#define SCANLIGHT_DECLARE_LANE_PATH(set, runs) \
    namespace set {                            \
    extern const LanePath lane_path;           \
    }
#define SCANLIGHT_ADD_LANE_PATH(set, runs) \
    if (runs) paths.push_back(&set::lane_path);

/// Defines a room's `lane_paths` within its namespace: those of all sets that this machine runs.
#define SCANLIGHT_DEFINE_LANE_PATHS                               \
    SCANLIGHT_FOR_EACH_SET(SCANLIGHT_DECLARE_LANE_PATH)           \
    std::span<const LanePath* const> lane_paths() {               \
        static const std::vector<const LanePath*> runnable = [] { \
            std::vector<const LanePath*> paths;                   \
            SCANLIGHT_FOR_EACH_SET(SCANLIGHT_ADD_LANE_PATH)       \
            return paths;                                         \
        }();                                                      \
        return runnable;                                          \
    }
