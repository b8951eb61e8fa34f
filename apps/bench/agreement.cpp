#include "apps/bench/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace scanlight::bench {

namespace {

float difference(const raster::Rgba& a, const raster::Rgba& b) {
    return std::max(
        {std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

}  // namespace

void require_same_picture(const std::string& method, const raster::Plane<raster::Rgba>& expected,
                          const raster::Plane<raster::Rgba>& actual, int most) {
    int different = 0;
    for (std::size_t i = 0; i < expected.values().size(); ++i) {
        different += difference(expected.values()[i], actual.values()[i]) > color_bound ? 1 : 0;
    }
    if (different <= most) return;
    throw std::runtime_error(method + " draws another picture than the library: " +
                             std::to_string(different) + " pixels differ");
}

}  // namespace scanlight::bench
