#include "raster/box_filter.h"

#include <algorithm>
#include <cstddef>

#include <glm/vec3.hpp>

namespace scanlight::raster {

namespace {

void add_samples(std::span<const Rgba> samples, std::size_t grid, std::span<Rgba> sums) {
    for (std::size_t x = 0; x < sums.size(); ++x) {
        for (const Rgba& sample : samples.subspan(x * grid, grid))
            sums[x] += Rgba(glm::vec3(sample) * sample.a, sample.a);
    }
}

Rgba mean(const Rgba& sum, float count) {
    return sum.a > 0.0f ? Rgba(glm::vec3(sum) / sum.a, sum.a / count) : Rgba(0.0f);
}

}  // namespace

void average_rows(const Plane<Rgba>& samples, int first_row, std::span<Rgba> pixels) {
    const int grid = samples.width() / static_cast<int>(pixels.size());
    std::ranges::fill(pixels, Rgba(0.0f));
    for (int y = first_row; y < first_row + grid; ++y)
        add_samples(samples.row(y), static_cast<std::size_t>(grid), pixels);
    for (Rgba& pixel : pixels)
        pixel = mean(pixel, static_cast<float>(grid * grid));
}

}  // namespace scanlight::raster
