#include "raster/marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "raster/image_error.h"
#include "raster/srgb.h"

namespace scanlight::raster {
namespace {

/// A bright rectangle that is not symmetrical, on grey.
Image8 flag() {
    Image8 image(20, 12, 3);
    for (auto& sample : image.samples())
        sample = 90;
    for (int y = 2; y < 7; ++y) {
        for (int x = 3; x < 9; ++x) {
            image.pixel(x, y)[0] = static_cast<std::uint8_t>(120 + 10 * x);
            image.pixel(x, y)[1] = static_cast<std::uint8_t>(20 * y);
            image.pixel(x, y)[2] = 30;
        }
    }
    return image;
}

Image8 without(Image8 image, int x, int y) {
    for (auto& sample : image.pixel(x, y))
        sample = 90;
    return image;
}

TEST(Marks, OfTheSamePictureAreAll) {
    const Marks marks = marks_of(flag(), flag(), 0);
    EXPECT_EQ(marks.judged, 30);
    EXPECT_EQ(marks.share(), 1.0);
}

TEST(Marks, OfAnEmptyPictureAreNone) {
    Image8 empty(20, 12, 3);
    for (auto& sample : empty.samples())
        sample = 90;
    EXPECT_EQ(marks_of(empty, flag(), 0).share(), 0.0);
    EXPECT_EQ(marks_of(empty, empty, 0).share(), 1.0);
}

TEST(Marks, CountWhatIsMissingAndWhatIsTooMuch) {
    const Marks missing = marks_of(without(flag(), 4, 3), flag(), 0);
    EXPECT_EQ(missing.judged, 30);
    EXPECT_EQ(missing.right, 29);
    Image8 more = flag();
    more.pixel(0, 0)[1] = 91;
    const Marks too_much = marks_of(more, flag(), 0);
    EXPECT_EQ(too_much.judged, 31);
    EXPECT_EQ(too_much.right, 30);
}

TEST(Marks, AllowADifferenceUpToTheTolerance) {
    Image8 off = flag();
    off.pixel(4, 3)[2] = 32;
    EXPECT_EQ(marks_of(off, flag(), 1.0 / 255).right, 29);
    EXPECT_EQ(marks_of(off, flag(), 2.0 / 255).right, 30);
}

TEST(Marks, OfFloatsThatAreNoNumbersAreCountedToo) {
    ImageF odd(4, 4, 3);
    for (int i = 0; i < 16; ++i)
        odd.pixel(i % 4, i / 4)[0] = i % 3 == 0 ? std::nanf("") : static_cast<float>(i % 2);
    const Marks marks = marks_of(odd, odd, 0);
    EXPECT_EQ(marks.right, marks.judged);
    EXPECT_GT(marks.judged, 0);
}

TEST(Marks, OfAnotherSizeAreNotToBeHad) {
    EXPECT_THROW(marks_of(Image8(3, 3, 3), flag(), 0), ImageError);
}

template <class Place>
Image8 rearranged(const Image8& image, Place place) {
    Image8 result = image;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto [i, j] = place(x, y);
            for (std::size_t c = 0; c < 3; ++c)
                result.pixel(x, y)[c] = image.pixel((i + 20) % 20, (j + 12) % 12)[c];
        }
    }
    return result;
}

TEST(LikelyMistake, IsSaid) {
    const Image8 right = flag();
    const auto mistake = [&](const AnyImage& image) { return likely_mistake(image, right, 0); };
    EXPECT_EQ(mistake(rearranged(right, [](int x, int y) { return std::pair(x, 11 - y); })),
              "it is upside down");
    EXPECT_EQ(mistake(rearranged(right, [](int x, int y) { return std::pair(19 - x, y); })),
              "left and right are exchanged");
    EXPECT_EQ(mistake(rearranged(right, [](int x, int y) { return std::pair(x - 1, y); })),
              "all of it lies one pixel too far right");
    EXPECT_EQ(mistake(rearranged(right, [](int x, int y) { return std::pair(x, y + 1); })),
              "all of it lies one pixel too high");
    Image8 exchanged = right;
    for (int i = 0; i < 20 * 12; ++i)
        std::swap(exchanged.pixel(i % 20, i / 20)[0], exchanged.pixel(i % 20, i / 20)[2]);
    EXPECT_EQ(mistake(exchanged), "red and blue are exchanged");
}

TEST(LikelyMistake, OfEncodingIsSaidThoughRoundingLosesSomeOfIt) {
    Image8 linear = flag();
    Image8 twice = flag();
    for (auto& sample : linear.samples())
        sample = static_cast<std::uint8_t>(linear_from_srgb(sample) * 255 + 0.5f);
    for (auto& sample : twice.samples())
        sample = srgb_from_linear(static_cast<float>(sample) / 255);
    EXPECT_EQ(likely_mistake(linear, flag(), 0), "linear light is not encoded as sRGB");
    EXPECT_EQ(likely_mistake(twice, flag(), 0), "sRGB is encoded twice");
}

TEST(LikelyMistake, OfWhatIsSimplyWrongIsNotInvented) {
    Image8 wrong = flag();
    for (int x = 3; x < 9; ++x)
        wrong.pixel(x, 4)[0] = 0;
    EXPECT_EQ(likely_mistake(wrong, flag(), 0), "");
    EXPECT_EQ(likely_mistake(Image8(20, 12, 3), flag(), 0), "");
}

}  // namespace
}  // namespace scanlight::raster
