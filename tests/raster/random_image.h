#pragma once

#include <random>

#include "raster/image.h"

namespace scanlight::raster {

/// Seeded pictures of any bits, for laws about files. Floats lie in [0, 1).
inline void fill_at_random(std::uint8_t& sample, std::mt19937& random) {
    sample = static_cast<std::uint8_t>(random() & 0xff);
}
inline void fill_at_random(std::uint16_t& sample, std::mt19937& random) {
    sample = static_cast<std::uint16_t>(random() & 0xffff);
}
inline void fill_at_random(float& sample, std::mt19937& random) {
    sample = static_cast<float>(random() >> 8) / 16777216.0f;
}

struct Shape {
    int width;
    int height;
    int channels;
};

template <class Sample>
Image<Sample> random_image(Shape shape, std::mt19937& random) {
    Image<Sample> image(shape.width, shape.height, shape.channels);
    for (Sample& sample : image.samples())
        fill_at_random(sample, random);
    return image;
}

/// Sizes at which row and run handling breaks first.
inline constexpr Shape odd_sizes[] = {{1, 1, 1},   {1, 7, 1},   {17, 3, 1},  {1, 1, 3},
                                      {1, 7, 3},   {17, 3, 3},  {7, 5, 3},   {8, 2, 3},
                                      {127, 2, 1}, {128, 2, 3}, {129, 2, 3}, {300, 4, 3}};

}  // namespace scanlight::raster
