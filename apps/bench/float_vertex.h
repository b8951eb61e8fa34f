#pragma once

#include <array>
#include <cstddef>

#include "raster/vertex.h"

namespace scanlight::bench {

/// Depth and attributes of a pixel or a corner in floating point. Depth keeps the library's scale.
template <int N>
struct FloatValues {
    float z = 0;
    std::array<float, N> attributes{};
};

/// a + t (b - a)
template <int N>
FloatValues<N> between(const FloatValues<N>& a, const FloatValues<N>& b, float t) {
    FloatValues<N> result;
    result.z = a.z + t * (b.z - a.z);
    for (std::size_t k = 0; k < N; ++k) {
        result.attributes[k] = a.attributes[k] + t * (b.attributes[k] - a.attributes[k]);
    }
    return result;
}

/// A corner in floating point; x and y in pixels.
template <int N>
struct FloatVertex {
    float x = 0;
    float y = 0;
    FloatValues<N> values;
};

template <int N>
FloatVertex<N> in_floats(const raster::ScreenVertex<N>& v) {
    constexpr float pixel = 1.0f / raster::subpixels;
    FloatVertex<N> result{static_cast<float>(v.x) * pixel, static_cast<float>(v.y) * pixel, {}};
    result.values.z = static_cast<float>(v.z);
    for (std::size_t k = 0; k < N; ++k) {
        result.values.attributes[k] = raster::float_from_attribute(v.attributes[k]);
    }
    return result;
}

}  // namespace scanlight::bench
