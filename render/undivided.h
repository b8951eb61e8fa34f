#pragma once

#include <algorithm>

#include <glm/vec3.hpp>

#include "raster/fixed.h"

namespace scanlight::render {

/// a = (a q) / q at a pixel. q is a 1 that ran along (see `raster::project_correct`); where the
/// polygon is so deep that its fixed point has no bits left for q, the smallest q stands in. One
/// division, then a multiplication a channel: other bits than three divisions.
inline glm::vec3 undivided(const glm::vec3& a_q, float q) {
    constexpr float smallest_q = 1.0f / raster::attribute_one;
    return a_q * (1.0f / std::max(q, smallest_q));
}

}  // namespace scanlight::render
