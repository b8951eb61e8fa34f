#pragma once

#include <cmath>

namespace scanlight::exercises {

inline bool is_dark(double u, double v, int count) {
    return std::fmod(std::abs(std::floor(count * u) + std::floor(count * v)), 2.0) == 1.0;
}

}  // namespace scanlight::exercises
