#pragma once

#include <cstdint>
#include <vector>

namespace scanlight::mesh {

/// A direction in the plane, as an angle's sine and cosine.
struct Direction {
    double sine;
    double cosine;
};

/// `count` directions all around, from angle 0 on.
std::vector<Direction> circle(std::uint32_t count);

}  // namespace scanlight::mesh
