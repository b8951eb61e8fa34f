#pragma once

#include <array>
#include <cstdint>

#include "raster/fixed.h"

namespace scanlight::raster {

/// A number that changes by the same step from one pixel (or scanline) to the next: the increment
/// of incremental interpolation. 16 more fraction bits than the number itself, rounded to nearest.
struct Ramp {
    std::int64_t value = 0;
    std::int64_t step_size = 0;

    static constexpr std::int64_t half = std::int64_t{1} << (ramp_bits - 1);

    void step() { value += step_size; }
    void step(int times) { value += times * step_size; }
    std::int32_t get() const { return static_cast<std::int32_t>((value + half) >> ramp_bits); }
};

/// All that is interpolated over a polygon: its depth and its attributes.
template <int N>
struct Ramps {
    Ramp depth;
    std::array<Ramp, N> attributes;

    void step() { step(1); }
    void step(int times) {
        depth.step(times);
        for (auto& ramp : attributes)
            ramp.step(times);
    }
};

}  // namespace scanlight::raster
