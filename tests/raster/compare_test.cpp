#include "raster/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raster/image_error.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Sample>
Image<Sample> row_of(int channels, std::initializer_list<Sample> samples) {
    Image<Sample> image(static_cast<int>(samples.size()) / channels, 1, channels);
    std::ranges::copy(samples, image.samples().begin());
    return image;
}

std::vector<int> pixel_of(const Image8& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {pixel.begin(), pixel.end()};
}

TEST(Compare, FindsNoDifferenceBetweenAPictureAndItself) {
    std::mt19937 random(1);
    for (const AnyImage& image : {AnyImage(random_image<std::uint8_t>({17, 3, 4}, random)),
                                  AnyImage(random_image<std::uint16_t>({1, 7, 1}, random)),
                                  AnyImage(random_image<float>({5, 5, 3}, random))}) {
        const Difference difference = compare(image, image);
        EXPECT_GT(difference.pixels, 0);
        EXPECT_EQ(difference.different_pixels, 0);
        EXPECT_EQ(difference.mean_absolute, 0);
        EXPECT_EQ(difference.root_mean_square, 0);
        EXPECT_FALSE(difference.worst.has_value());
        EXPECT_EQ(psnr_db(difference), infinity);
    }
}

TEST(Compare, FindsAnySingleChangedSample) {
    std::mt19937 random(2);
    for (int i = 0; i < 200; ++i) {
        const auto first = random_image<std::uint8_t>({13, 11, 3}, random);
        const int x = static_cast<int>(random() % 13);
        const int y = static_cast<int>(random() % 11);
        const int c = static_cast<int>(random() % 3);
        auto second = first;
        auto& changed = second.pixel(x, y)[static_cast<std::size_t>(c)];
        changed = static_cast<std::uint8_t>(changed ^ 1);
        const Difference difference = compare(first, second);
        ASSERT_EQ(difference.different_pixels, 1);
        ASSERT_TRUE(difference.worst.has_value());
        EXPECT_EQ(difference.worst->x, x);
        EXPECT_EQ(difference.worst->y, y);
        EXPECT_EQ(difference.worst->channel, c);
        EXPECT_EQ(difference.worst->first, first.pixel(x, y)[static_cast<std::size_t>(c)]);
        EXPECT_EQ(difference.worst->second, changed);
        EXPECT_EQ(difference.mean_absolute, 1.0 / (13 * 11 * 3));
    }
}

TEST(Compare, AgreesWithTheHand) {
    const auto first = row_of<std::uint8_t>(1, {10, 20, 30, 40});
    const auto second = row_of<std::uint8_t>(1, {13, 20, 26, 40});
    const Difference difference = compare(first, second);
    EXPECT_EQ(difference.pixels, 4);
    EXPECT_EQ(difference.different_pixels, 2);
    EXPECT_EQ(difference.mean_absolute, 7.0 / 4);
    EXPECT_EQ(difference.root_mean_square, 2.5);
    EXPECT_EQ(difference.peak, 255);
    EXPECT_EQ(difference.worst->x, 2);
    EXPECT_DOUBLE_EQ(psnr_db(difference), 20 * std::log10(102.0));
}

TEST(Compare, BlackAndWhiteAreZeroDecibelsApart) {
    for (const auto& [black, white] :
         {std::pair<AnyImage, AnyImage>(row_of<std::uint8_t>(1, {0}),
                                        row_of<std::uint8_t>(1, {255})),
          std::pair<AnyImage, AnyImage>(row_of<std::uint16_t>(1, {0}),
                                        row_of<std::uint16_t>(1, {65535})),
          std::pair<AnyImage, AnyImage>(row_of<float>(1, {0}), row_of<float>(1, {1}))}) {
        EXPECT_EQ(psnr_db(compare(black, white)), 0);
    }
}

TEST(Compare, NamesTheFirstOfEquallyBadSamples) {
    const Difference difference = compare(row_of<std::uint8_t>(3, {0, 0, 0, 0, 9, 9}),
                                          row_of<std::uint8_t>(3, {0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(difference.worst->x, 1);
    EXPECT_EQ(difference.worst->channel, 1);
}

TEST(Compare, IsTheSameFromBothSides) {
    std::mt19937 random(3);
    const auto first = random_image<float>({31, 7, 3}, random);
    const auto second = random_image<float>({31, 7, 3}, random);
    const Difference there = compare(first, second);
    const Difference back = compare(second, first);
    EXPECT_EQ(there.mean_absolute, back.mean_absolute);
    EXPECT_EQ(there.root_mean_square, back.root_mean_square);
    EXPECT_EQ(there.worst->first, back.worst->second);
}

TEST(Compare, MeetsInTheWiderKind) {
    const auto grey8 = row_of<std::uint8_t>(1, {7});
    EXPECT_EQ(compare(grey8, row_of<std::uint16_t>(1, {7 * 257})).different_pixels, 0);
    EXPECT_EQ(compare(grey8, row_of<std::uint8_t>(3, {7, 7, 7})).different_pixels, 0);
    EXPECT_EQ(compare(grey8, row_of<std::uint8_t>(2, {7, 255})).different_pixels, 0);
    EXPECT_EQ(compare(grey8, row_of<std::uint8_t>(4, {7, 7, 7, 255})).different_pixels, 0);
    EXPECT_EQ(compare(grey8, row_of<std::uint8_t>(4, {7, 7, 7, 254})).worst->channel, 3);
    EXPECT_EQ(compare(row_of<std::uint8_t>(2, {7, 9}), row_of<std::uint8_t>(4, {7, 7, 7, 9}))
                  .different_pixels,
              0);
    const Difference wide = compare(grey8, row_of<std::uint16_t>(1, {7 * 257 + 1}));
    EXPECT_EQ(wide.mean_absolute, 1);
    EXPECT_EQ(wide.peak, 65535);
}

TEST(Compare, EightBitsSpreadOverSixteenExactly) {
    Image8 narrow(256, 1, 1);
    Image16 wide(256, 1, 1);
    for (int v = 0; v < 256; ++v) {
        narrow.pixel(v, 0)[0] = static_cast<std::uint8_t>(v);
        wide.pixel(v, 0)[0] = static_cast<std::uint16_t>(v * 257);
    }
    EXPECT_EQ(compare(narrow, wide).different_pixels, 0);
}

TEST(Compare, SaysWhyPicturesCannotBeCompared) {
    try {
        compare(Image8(2, 3, 1), Image8(3, 2, 1));
        FAIL();
    } catch (const ImageError& error) {
        EXPECT_STREQ(error.what(), "the sizes differ: 2 x 3 and 3 x 2");
    }
    EXPECT_THROW(compare(Image8(1, 1, 1), ImageF(1, 1, 1)), ImageError);
    EXPECT_THROW(difference_image(ImageF(1, 1, 1), Image16(1, 1, 1)), ImageError);
}

TEST(Compare, CountsNumbersThatAreNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(
        compare(row_of<float>(1, {nan, inf, -inf, -0.0f}), row_of<float>(1, {nan, inf, -inf, 0.0f}))
            .different_pixels,
        0);
    const Difference difference =
        compare(row_of<float>(1, {0.5f, 1, inf}), row_of<float>(1, {0.25f, nan, -inf}));
    EXPECT_EQ(difference.different_pixels, 3);
    EXPECT_EQ(difference.mean_absolute, infinity);
    EXPECT_EQ(difference.worst->x, 1);
}

TEST(DifferenceImage, LightsUpExactlyTheChangedPixels) {
    const auto first = row_of<std::uint8_t>(3, {255, 255, 255, 8, 8, 8, 0, 0, 0, 255, 0, 0});
    const auto second = row_of<std::uint8_t>(3, {255, 255, 255, 8, 9, 8, 0, 0, 0, 0, 0, 0});
    const Image8 picture = difference_image(first, second);
    EXPECT_EQ(pixel_of(picture, 0, 0), (std::vector{80, 80, 80}));
    EXPECT_EQ(pixel_of(picture, 1, 0), (std::vector{150, 0, 0}));
    EXPECT_EQ(pixel_of(picture, 2, 0), (std::vector{0, 0, 0}));
    EXPECT_EQ(pixel_of(picture, 3, 0), (std::vector{255, 255, 255}));
}

TEST(DifferenceImage, DimsWhatIsEqualByItsLuminance) {
    const auto image = row_of<std::uint8_t>(3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 8, 8, 8});
    const Image8 picture = difference_image(image, image);
    EXPECT_EQ(pixel_of(picture, 0, 0), (std::vector{20, 20, 20}));
    EXPECT_EQ(pixel_of(picture, 1, 0), (std::vector{50, 50, 50}));
    EXPECT_EQ(pixel_of(picture, 2, 0), (std::vector{10, 10, 10}));
    EXPECT_EQ(pixel_of(picture, 3, 0), (std::vector{3, 3, 3}));  // 2.5
}

TEST(DifferenceImage, EachStepIsTwiceTheDifference) {
    Image8 zero(256, 1, 1);
    Image8 ramp(256, 1, 1);
    for (int v = 0; v < 256; ++v)
        ramp.pixel(v, 0)[0] = static_cast<std::uint8_t>(v);
    const Image8 picture = difference_image(zero, ramp);
    for (int v = 2; v < 256; ++v) {
        const bool same = pixel_of(picture, v, 0) == pixel_of(picture, v - 1, 0);
        EXPECT_EQ(same, (v & (v - 1)) != 0) << v;
    }
}

TEST(DifferenceImage, ShowsTheSmallestAndTheWildestFloats) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Image8 picture = difference_image(row_of<float>(1, {1, 1, nan, -3}),
                                            row_of<float>(1, {1.0000001f, 1e30f, nan, -3}));
    EXPECT_EQ(pixel_of(picture, 0, 0), (std::vector{150, 0, 0}));
    EXPECT_EQ(pixel_of(picture, 1, 0), (std::vector{255, 255, 255}));
    EXPECT_EQ(pixel_of(picture, 2, 0), (std::vector{0, 0, 0}));
    EXPECT_EQ(pixel_of(picture, 3, 0), (std::vector{0, 0, 0}));
}

}  // namespace
}  // namespace scanlight::raster
