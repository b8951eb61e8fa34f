#include "mesh/srgb.h"

#include <array>
#include <cstddef>

namespace scanlight::mesh {
namespace {

/// For x in (0, 1]. Newton's method from above descends to the root and stays there.
consteval double fifth_root(double x) {
    double root = 1;
    for (int i = 0; i < 64; ++i) {
        const double fourth = root * root * root * root;
        root -= (fourth * root - x) / (5 * fourth);
    }
    return root;
}

consteval double decoded(double value_srgb) {
    if (value_srgb <= 0.04045) return value_srgb / 12.92;
    const double base = (value_srgb + 0.055) / 1.055;
    const double root = fifth_root(base);
    return base * base * root * root;  // base to the 2.4
}

consteval std::array<float, 256> decoded_bytes() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<float>(decoded(static_cast<double>(i) / 255));
    }
    return table;
}

constexpr std::array<float, 256> linear_light = decoded_bytes();

}  // namespace

float linear_from_srgb(std::uint8_t value_srgb) {
    return linear_light[value_srgb];
}

}  // namespace scanlight::mesh
