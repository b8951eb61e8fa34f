#pragma once

#include <array>

#include <glm/vec4.hpp>

#include "raster/fixed.h"

namespace scanlight::raster {

/// A polygon's corner in clip space, before the division by w. N attributes travel with it.
template <int N>
struct ClipVertex {
    glm::vec4 position{};
    std::array<float, N> attributes{};
};

/// A polygon's corner on the screen, snapped to 1/256 pixel; everything from here on is exact.
template <int N>
struct ScreenVertex {
    SubPixel x = 0;
    SubPixel y = 0;
    Depth z = 0;
    std::array<Attribute, N> attributes{};
};

}  // namespace scanlight::raster
