#include "raster/hdr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/raster/bad_bytes.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

using namespace std::string_view_literals;

ImageF through_file(const ImageF& image) {
    return std::get<ImageF>(decode_image({"picture", encode_hdr(image)}));
}

float brightest(std::span<const float> pixel) {
    return *std::max_element(pixel.begin(), pixel.end());
}

std::string flat(std::string_view size, std::string_view pixels) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + std::string(size) + "\n" +
           std::string(pixels);
}

float read_light(float light) {
    ImageF image(1, 1, 1);
    image.pixel(0, 0)[0] = light;
    return through_file(image).pixel(0, 0)[0];
}

TEST(Hdr, LosesLessThanOneOf128PartsOfTheBrightestChannel) {
    std::mt19937 random(1);
    for (const Shape shape : odd_sizes) {
        if (shape.channels != 3) continue;
        const auto image = random_image<float>(shape, random);
        const ImageF read = through_file(image);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const float lost = image.pixel(x, y)[c] - read.pixel(x, y)[c];
                    ASSERT_GE(lost, 0);
                    ASSERT_LT(lost, brightest(image.pixel(x, y)) / 128);
                }
            }
        }
    }
}

TEST(Hdr, ReadsAndWritesItsOwnPicturesWithoutLoss) {
    std::mt19937 random(2);
    for (const Shape shape : odd_sizes) {
        const ImageF once = through_file(random_image<float>(shape, random));
        EXPECT_EQ(through_file(once), once) << shape.width << " x " << shape.height;
    }
}

TEST(Hdr, KeepsLongRuns) {
    ImageF image(1000, 2, 3);
    for (int x = 100; x < 900; ++x)
        image.pixel(x, 1)[1] = 0.5f;
    EXPECT_EQ(through_file(image), image);
}

TEST(Hdr, KeepsPowersOfTwoOverItsRange) {
    for (int e = -106; e < 127; ++e)
        EXPECT_EQ(read_light(std::ldexp(1.0f, e)), std::ldexp(1.0f, e));
}

TEST(Hdr, TamesLightThatItCannotHold) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float largest = 0xffp119f;
    EXPECT_EQ(read_light(-1.0f), 0);
    EXPECT_EQ(read_light(-infinity), 0);
    EXPECT_EQ(read_light(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(read_light(1e-33f), 0);
    EXPECT_EQ(read_light(largest), largest);
    EXPECT_EQ(read_light(std::nextafter(largest, infinity)), largest);
    EXPECT_EQ(read_light(std::numeric_limits<float>::max()), largest);
    EXPECT_EQ(read_light(infinity), largest);
}

TEST(Hdr, ANegativeChannelLeavesItsNeighboursAlone) {
    ImageF image(1, 1, 3);
    image.pixel(0, 0)[0] = -5.0f;
    image.pixel(0, 0)[1] = 1.0f;
    const ImageF read = through_file(image);
    EXPECT_EQ(read.pixel(0, 0)[0], 0);
    EXPECT_EQ(read.pixel(0, 0)[1], 1);
}

TEST(Hdr, ReadsAFlatPixel) {
    const auto file = file_of(flat("-Y 1 +X 1", "\x80\x40\x01\x81"));
    const ImageF image = std::get<ImageF>(decode_image(file));
    EXPECT_EQ(image.pixel(0, 0)[0], 1.0f);
    EXPECT_EQ(image.pixel(0, 0)[1], 0.5f);
    EXPECT_EQ(image.pixel(0, 0)[2], 1.0f / 128);
}

TEST(Hdr, RefusesEveryBeginningOfAFile) {
    std::mt19937 random(3);
    expect_no_beginning_is_read(encode_hdr(random_image<float>({3, 2, 3}, random)));
    expect_no_beginning_is_read(encode_hdr(random_image<float>({9, 2, 3}, random)));
}

TEST(Hdr, SurvivesDamage) {
    std::mt19937 random(4);
    const Bytes whole = encode_hdr(random_image<float>({9, 3, 3}, random));
    EXPECT_GT(refused_of_damaged(whole, 2000, 5), 0);
}

// 8 pixels wide: the row begins 2 2 0 8, then four components.
TEST(Hdr, RefusesRunsThatDoNotFitTheirRow) {
    const std::string_view good =
        "\2\2\0\x8\x88"
        "A\x88"
        "A\x88"
        "A\x88"
        "A"sv;
    EXPECT_EQ(complaint(file_of(flat("-Y 1 +X 8", good))), "");
    const std::string_view bad[] = {
        "\2\2\0\x8\x89"
        "A\x88"
        "A\x88"
        "A\x88"
        "A"sv,                                        // a run of 9
        "\2\2\0\x8\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"sv,  // runs of nothing
        "\2\2\0\x9\x88"
        "A\x88"
        "A\x88"
        "A\x88"
        "A"sv,  // another width
        "\2\2\0\x8\x9"
        "ABCDEFGHI\x88"
        "A\x88"
        "A\x88"
        "A"sv,  // 9 different ones
    };
    for (const auto row : bad)
        EXPECT_NE(complaint(file_of(flat("-Y 1 +X 8", row))), "");
}

TEST(Hdr, RefusesWhatItDoesNotRead) {
    const std::string pixel = "AAAA";
    const std::string bad[] = {flat("+Y 1 +X 1", pixel),
                               flat("-Y 1 -X 1", pixel),
                               flat("+X 1 -Y 1", pixel),
                               flat("-Y 0 +X 1", pixel),
                               flat("-Y 1 +X 0", pixel),
                               flat("-Y -1 +X 1", pixel),
                               flat("-Y 1 +X 1", "AAAAA"),
                               flat("-Y 1 +X 1", "\1\1\1\1"),
                               "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nAAAA",
                               "#?OTHER\n\n-Y 1 +X 1\nAAAA"};
    for (const auto& text : bad)
        EXPECT_NE(complaint(file_of(text)), "") << text;
}

}  // namespace
}  // namespace scanlight::raster
