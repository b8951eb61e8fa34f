#pragma once

#include <cstdint>
#include <random>

#include "shading/vector.h"

namespace scanlight::shading {

/// Seeded random input, the same on every system.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    // The order of calls is part of the input: at most one of them to a function's arguments.
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32);
    }

    Vec3<double> in_cube(double half_side) {
        const double x = between(-half_side, half_side);
        const double y = between(-half_side, half_side);
        return {x, y, between(-half_side, half_side)};
    }

    Vec3<double> unit_vector() {
        for (;;) {
            const Vec3<double> v = in_cube(1);
            const double squared = dot(v, v);
            if (squared > 0.01 && squared < 1) return unit(v);
        }
    }

    /// On the same side as `normal`, at least `least_cosine` above the horizon.
    Vec3<double> above(const Vec3<double>& normal, double least_cosine = 0) {
        for (;;) {
            const Vec3<double> v = unit_vector();
            if (dot(v, normal) > least_cosine) return v;
        }
    }

    Rgb<double> color() {
        const double red = between(0, 1);
        const double green = between(0, 1);
        return {red, green, between(0, 1)};
    }

private:
    std::mt19937 engine_;
};

}  // namespace scanlight::shading
