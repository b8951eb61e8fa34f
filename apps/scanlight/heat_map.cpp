#include "apps/scanlight/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "apps/scanlight/label.h"
#include "raster/image_of.h"

namespace scanlight::apps {

namespace {

constexpr Color8 zero{58, 60, 66};
constexpr std::array<Color8, 5> more{
    {{255, 237, 160}, {254, 178, 76}, {252, 100, 45}, {200, 20, 30}, {110, 0, 38}}};
constexpr std::array<Color8, 3> less{{{198, 219, 239}, {66, 146, 198}, {8, 48, 107}}};

/// `t` from 0, the first colour, to 1, the last.
template <std::size_t count>
Color8 between(const std::array<Color8, count>& colors, double t) {
    const double place = t * (count - 1);
    const auto first = std::min(static_cast<std::size_t>(place), count - 2);
    Color8 result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double from = colors[first][k];
        const double to = colors[first + 1][k];
        result[k] = static_cast<std::uint8_t>(
            std::lrint(from + (to - from) * (place - static_cast<double>(first))));
    }
    return result;
}

struct Range {
    int least, largest;  // not above, not below 0

    Color8 color_of(int count) const {
        if (count == 0) return zero;
        const auto share = [](int part, int whole) {
            return whole == 1 ? 0.0 : (part - 1.0) / (whole - 1.0);
        };
        return count > 0 ? between(more, share(count, largest))
                         : between(less, share(-count, -least));
    }
};

Range range_of(const raster::Plane<std::int32_t>& counts) {
    const auto [least, largest] = std::ranges::minmax_element(counts.values());
    return {std::min(*least, 0), std::max(*largest, 0)};
}

/// From the largest down; where there are more than `most`, evenly chosen.
std::vector<int> legend_entries(const Range& range, int most) {
    const int steps = range.largest - range.least;
    const int entries = std::clamp(steps + 1, 1, std::max(most, 2));
    std::vector<int> result;
    for (int i = 0; i < entries; ++i)
        result.push_back(entries == 1 ? 0 : range.largest - steps * i / (entries - 1));
    return result;
}

void draw_legend(raster::Image8& picture, const Range& range) {
    constexpr int row_height = 12;
    constexpr int box = 8;
    constexpr Color8 paper{24, 25, 28};
    constexpr Color8 ink{235, 235, 235};
    const auto entries = legend_entries(range, std::min(12, picture.height() / row_height - 1));
    const int text = std::max(text_width(std::to_string(range.least)),
                              text_width(std::to_string(range.largest)));
    const int width = box + text + 12;
    const int left = picture.width() - width;
    fill_box(picture, left, 0, width, row_height * static_cast<int>(entries.size()) + 4, paper);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const int y = 4 + row_height * static_cast<int>(i);
        fill_box(picture, left + 4, y, box, box, range.color_of(entries[i]));
        write_text(picture, left + box + 8, y + 1, std::to_string(entries[i]), ink);
    }
}

}  // namespace

raster::Image8 heat_map(const raster::Plane<std::int32_t>& counts) {
    const Range range = range_of(counts);
    raster::Image8 picture =
        raster::image_of<std::uint8_t>(counts, 3, [&](auto pixel, std::int32_t count) {
            std::ranges::copy(range.color_of(count), pixel.begin());
        });
    draw_legend(picture, range);
    return picture;
}

}  // namespace scanlight::apps
