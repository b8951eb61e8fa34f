#include "raster/pfm.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "tests/raster/bad_bytes.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

using namespace std::string_view_literals;

std::vector<std::uint32_t> bits_of(const ImageF& image) {
    std::vector<std::uint32_t> bits;
    for (const float sample : image.samples())
        bits.push_back(std::bit_cast<std::uint32_t>(sample));
    return bits;
}

TEST(Pfm, KeepsEveryBitOfEveryFloat) {
    std::mt19937 random(1);
    for (const Shape shape : odd_sizes) {
        ImageF image(shape.width, shape.height, shape.channels);
        for (float& sample : image.samples()) {  // NaN, infinities and denormals among them
            sample = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        }
        const ImageF read = std::get<ImageF>(decode_image({"picture", encode_pfm(image)}));
        EXPECT_EQ(read.width(), image.width());
        EXPECT_EQ(read.channels(), image.channels());
        EXPECT_EQ(bits_of(read), bits_of(image));
    }
}

TEST(Pfm, WritesTheBottomRowFirstAndLittleEndian) {
    ImageF image(1, 2, 1);
    image.pixel(0, 0)[0] = 1.0f;  // 0x3f800000
    image.pixel(0, 1)[0] = 2.0f;  // 0x40000000
    EXPECT_EQ(encode_pfm(image), file_of("Pf\n1 2\n-1.0\n\0\0\0\x40\0\0\x80\x3f"sv).bytes);
}

TEST(Pfm, ReadsBigEndianToo) {
    const ImageF image = std::get<ImageF>(decode_image(file_of("Pf\n1 1\n2.5\n\x3f\x80\0\0"sv)));
    EXPECT_EQ(image.pixel(0, 0)[0], 1.0f);
}

TEST(Pfm, RefusesEveryBeginningOfAFile) {
    std::mt19937 random(2);
    expect_no_beginning_is_read(encode_pfm(random_image<float>({3, 2, 3}, random)));
}

TEST(Pfm, SurvivesDamage) {
    std::mt19937 random(3);
    const Bytes whole = encode_pfm(random_image<float>({3, 2, 1}, random));
    EXPECT_GT(refused_of_damaged(whole, 1000, 4), 0);
}

TEST(Pfm, RefusesWhatItDoesNotRead) {
    const std::string_view bad[] = {"Pf 1 1 0\n\0\0\0\0"sv,   "Pf 1 1 nan\n\0\0\0\0"sv,
                                    "Pf 1 1 x\n\0\0\0\0"sv,   "Pf 1 1 -1.0x\0\0\0\0"sv,
                                    "PF4 1 1 -1\n\0\0\0\0"sv, "Pf 1 1 -1\n\0\0\0\0\0"sv,
                                    "Pf 0 1 -1\n"sv,          "Pf 1 0 -1\n"sv,
                                    "Pf -1 1 -1\n\0\0\0\0"sv, "Pf 1 1 -1e99\n\0\0\0\0"sv};
    for (const auto text : bad)
        EXPECT_NE(complaint(file_of(text)), "") << text;
}

}  // namespace
}  // namespace scanlight::raster
