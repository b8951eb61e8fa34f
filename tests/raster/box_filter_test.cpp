#include "raster/box_filter.h"

#include <gtest/gtest.h>

#include <vector>

namespace scanlight::raster {
namespace {

Rgba grey(float value) {
    return Rgba(value, value, value, 1.0f);
}

/// Sample (x, y) is x + 10 y.
Plane<Rgba> numbered(int width, int height) {
    Plane<Rgba> plane({width, height}, Rgba(0.0f));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            plane.at(x, y) = grey(static_cast<float>(x + 10 * y));
    }
    return plane;
}

TEST(AverageRows, GivesEachPixelTheMeanOfItsSquare) {
    std::vector<Rgba> pixels(2, grey(77.0f));
    average_rows(numbered(4, 4), 2, pixels);
    EXPECT_EQ(pixels[0], grey(25.5f));  // 20, 21, 30, 31
    EXPECT_EQ(pixels[1], grey(27.5f));
}

TEST(AverageRows, OfOneSampleIsThatSample) {
    const Plane<Rgba> samples = numbered(3, 2);
    std::vector<Rgba> pixels(3);
    average_rows(samples, 1, pixels);
    EXPECT_EQ(pixels, std::vector<Rgba>(samples.row(1).begin(), samples.row(1).end()));
}

TEST(AverageRows, AddsRowByRowFromLeftToRight) {
    Plane<Rgba> samples({2, 2}, Rgba(0.0f));
    samples.at(0, 0) = grey(0x1p24f);
    samples.at(1, 0) = grey(1.0f);  // is lost
    samples.at(0, 1) = grey(-0x1p24f);
    samples.at(1, 1) = grey(1.0f);  // is not
    std::vector<Rgba> pixels(1);
    average_rows(samples, 0, pixels);
    EXPECT_EQ(pixels[0], grey(0.25f));
}

TEST(AverageRows, WeighsColorsByAlpha) {
    Plane<Rgba> samples({2, 2}, Rgba(9.0f, 9.0f, 9.0f, 0.0f));
    samples.at(0, 0) = Rgba(0.5f, 0.25f, 0.0f, 1.0f);
    samples.at(1, 1) = Rgba(1.0f, 0.25f, 4.0f, 0.5f);
    std::vector<Rgba> pixels(1);
    average_rows(samples, 0, pixels);
    EXPECT_EQ(pixels[0], Rgba(1.0f / 1.5f, 0.375f / 1.5f, 2.0f / 1.5f, 0.375f));
}

TEST(AverageRows, OfNothingAreNothing) {
    const Plane<Rgba> samples({2, 2}, Rgba(3.0f, 2.0f, 1.0f, 0.0f));
    std::vector<Rgba> pixels(1);
    average_rows(samples, 0, pixels);
    EXPECT_EQ(pixels[0], Rgba(0.0f));
}

}  // namespace
}  // namespace scanlight::raster
