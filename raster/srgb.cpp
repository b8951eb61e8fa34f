#include "raster/srgb.h"

#include <array>
#include <bit>
#include <cstddef>
#include <limits>

namespace scanlight::raster {

namespace {

// The tables are worked out by the compiler, with + - x / only: no libm, so no doubt about bits.
// A double leaves 29 bits beyond float for the error of these few steps; a test compares every
// entry with long double.

// Newton's iteration on r^5 - x, for x in (0, 1]. From 1 it falls until rounding stops it.
constexpr double fifth_root(double x) {
    double root = 1;
    for (;;) {
        const double fourth = root * root * root * root;
        const double next = root - (root - x / fourth) / 5;
        if (!(next < root)) return root;
        root = next;
    }
}

constexpr double power_2_4(double x) {
    const double root = fifth_root(x);
    const double cube = root * root * root;
    return cube * cube * cube * cube;
}

constexpr double decoded(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : power_2_4((srgb + 0.055) / 1.055);
}

constexpr float smallest_float_from(double bound) {
    const auto nearest = static_cast<float>(bound);
    if (static_cast<double>(nearest) >= bound) return nearest;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(nearest) + 1);
}

// thresholds[v] is the smallest intensity that is brighter than v; none is brighter than 255.
constexpr auto thresholds = [] {
    std::array<float, 256> table{};
    for (std::size_t v = 0; v < 255; ++v) {
        table[v] = smallest_float_from(decoded((static_cast<double>(v) + 0.5) / 255));
    }
    table[255] = std::numeric_limits<float>::infinity();
    return table;
}();

constexpr auto linear_values = [] {
    std::array<float, 256> table{};
    for (std::size_t v = 0; v < 256; ++v) {
        table[v] = static_cast<float>(decoded(static_cast<double>(v) / 255));
    }
    return table;
}();

// The floats of [2^-13, 1) fall into cells by exponent and the first seven bits of the fraction. A
// cell is so narrow that it holds at most one threshold: its first value and one comparison decide.
constexpr float cells_begin = 1.0f / 8192;
constexpr std::uint32_t cell_bits = 16;
constexpr std::size_t cell_count = 13 * 128;

constexpr std::size_t cell_of(float x) {
    return (std::bit_cast<std::uint32_t>(x) - std::bit_cast<std::uint32_t>(cells_begin)) >>
           cell_bits;
}

constexpr float cell_start(std::size_t cell) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(cells_begin) +
                                (static_cast<std::uint32_t>(cell) << cell_bits));
}

constexpr auto first_values = [] {
    std::array<std::uint8_t, cell_count + 1> table{};
    std::uint8_t value = 0;
    for (std::size_t cell = 0; cell <= cell_count; ++cell) {
        while (cell_start(cell) >= thresholds[value])
            ++value;
        table[cell] = value;
    }
    return table;
}();

constexpr bool one_threshold_a_cell() {
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
        if (first_values[cell + 1] - first_values[cell] > 1) return false;
    }
    return true;
}

static_assert(thresholds[0] > cells_begin && thresholds[254] < 1);
static_assert(cell_start(cell_count) == 1);
static_assert(one_threshold_a_cell());

constexpr std::int32_t srgb_cell(std::size_t cell) {
    const std::uint8_t value = first_values[cell];
    const bool has_step = thresholds[value] < cell_start(cell + 1);
    const std::int32_t step =
        has_step
            ? static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(thresholds[value]) & 0xffff)
            : 1 << cell_bits;
    return std::int32_t{value} << (cell_bits + 1) | step;
}

}  // namespace

const std::array<std::int32_t, 13 * 128> srgb_cells = [] {
    std::array<std::int32_t, cell_count> table{};
    for (std::size_t cell = 0; cell < cell_count; ++cell)
        table[cell] = srgb_cell(cell);
    return table;
}();

std::uint8_t srgb_from_linear(float linear) noexcept {
    if (!(linear >= cells_begin)) return 0;  // NaN too
    if (linear >= 1) return 255;
    const std::uint8_t value = first_values[cell_of(linear)];
    return static_cast<std::uint8_t>(value + (linear >= thresholds[value] ? 1 : 0));
}

float linear_from_srgb(std::uint8_t srgb) noexcept {
    return linear_values[srgb];
}

}  // namespace scanlight::raster
