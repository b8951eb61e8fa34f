#include "apps/demo/window/round.h"

#include <cmath>

namespace scanlight::apps::window {

double rounded(double value, double size, int digits) {
    if (!(size > 0.0)) return value;
    const int places = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
    // Powers of ten above 1 are exact: 0.1 would not be what a person writes.
    const double scale = std::pow(10.0, std::abs(places));
    return places >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

glm::dvec3 rounded(const glm::dvec3& value, double size, int digits) {
    return {rounded(value.x, size, digits), rounded(value.y, size, digits),
            rounded(value.z, size, digits)};
}

}  // namespace scanlight::apps::window
