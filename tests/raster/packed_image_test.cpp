#include "raster/packed_image.h"

#include <gtest/gtest.h>

#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

TEST(PackedImage, HasTheBytesOfThePictureAndIsOpaque) {
    std::mt19937 random(3);
    const auto image = random_image<std::uint8_t>({7, 5, 3}, random);
    const Plane<PackedPixel> packed = packed_image(image);
    ASSERT_EQ(packed.width(), 7);
    ASSERT_EQ(packed.height(), 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) {
            const PackedPixel pixel = packed.at(x, y);
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_EQ(pixel >> 8 * channel & 0xff, image.pixel(x, y)[channel]);
            EXPECT_EQ(pixel >> 24, 0xffu);
        }
    }
}

}  // namespace
}  // namespace scanlight::raster
