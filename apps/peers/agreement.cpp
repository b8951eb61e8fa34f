#include "apps/peers/agreement.h"

#include <cassert>
#include <cstdlib>

namespace scanlight::peers {

namespace {

using Picture = raster::Plane<raster::PackedPixel>;

bool is_covered(raster::PackedPixel pixel) {
    return pixel >> 24 != 0;
}

bool is_covered_at(const Picture& picture, int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return true;
    return is_covered(picture.at(x, y));
}

bool is_on_outline(const Picture& picture, int x, int y) {
    return is_covered_at(picture, x, y) &&
           !(is_covered_at(picture, x - 1, y) && is_covered_at(picture, x + 1, y) &&
             is_covered_at(picture, x, y - 1) && is_covered_at(picture, x, y + 1));
}

/// Summed over red, green and blue.
int difference(raster::PackedPixel a, raster::PackedPixel b) {
    int sum = 0;
    for (const int shift : {0, 8, 16}) {
        sum += std::abs(static_cast<int>(a >> shift & 0xff) - static_cast<int>(b >> shift & 0xff));
    }
    return sum;
}

std::size_t outline_of(const Picture& picture) {
    std::size_t count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            count += is_on_outline(picture, x, y) ? 1 : 0;
    }
    return count;
}

}  // namespace

Agreement agreement(const Picture& a, const Picture& b) {
    assert(a.values().size() == b.values().size());
    Agreement result;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const bool in_a = is_covered(a.values()[i]);
        const bool in_b = is_covered(b.values()[i]);
        result.only_one += in_a != in_b ? 1 : 0;
        if (!in_a || !in_b) continue;
        ++result.covered;
        sum += static_cast<std::size_t>(difference(a.values()[i], b.values()[i]));
    }
    result.outline = outline_of(a);
    if (result.covered > 0)
        result.color_difference =
            static_cast<double>(sum) / static_cast<double>(3 * result.covered);
    return result;
}

bool agrees(const Agreement& agreement) {
    constexpr std::size_t a_few = 8;
    return agreement.covered > 0 && agreement.only_one <= a_few + agreement.outline * 3 / 1000 &&
           agreement.color_difference < 1.0;
}

}  // namespace scanlight::peers
