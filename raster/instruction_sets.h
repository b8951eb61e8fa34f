#pragma once

// The instruction sets for which the sources in the folders named `lanes` are compiled, each in a
// namespace of its own; see `scanlight_lanes` in the top CMakeLists.txt. The fastest comes first,
// each with the question whether this machine runs it: the compilers' own rather than that of
// Highway, whose library takes five milliseconds to start.

#ifdef SCANLIGHT_X86_LANES

#define SCANLIGHT_FOR_EACH_SET(USE) \
    USE(N_AVX3, runs_v4())          \
    USE(N_AVX2, runs_v3())          \
    USE(N_SSE4, runs_v2())          \
    USE(N_EMU128, true)

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

/// Declares a room's `lane_path` of one set.
#define SCANLIGHT_DECLARE_LANE_PATH(set, runs) \
    namespace set {                            \
    extern const LanePath lane_path;           \
    }
