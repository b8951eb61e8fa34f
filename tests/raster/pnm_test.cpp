#include "raster/pnm.h"

#include <gtest/gtest.h>

#include "tests/raster/bad_bytes.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

using namespace std::string_view_literals;

template <class Sample>
void expect_round_trip(Shape shape, std::mt19937& random) {
    const auto image = random_image<Sample>(shape, random);
    const AnyImage read = decode_image({"picture", encode_pnm(image)});
    ASSERT_TRUE(std::holds_alternative<Image<Sample>>(read));
    EXPECT_EQ(std::get<Image<Sample>>(read), image) << shape.width << " x " << shape.height;
}

TEST(Pnm, ReadsWhatItWrote) {
    std::mt19937 random(1);
    for (const Shape shape : odd_sizes) {
        expect_round_trip<std::uint8_t>(shape, random);
        expect_round_trip<std::uint16_t>(shape, random);
    }
}

TEST(Pnm, WritesPlainHeadersAndBigEndianSamples) {
    Image8 colour(1, 1, 3);
    colour.pixel(0, 0)[2] = 'B';
    EXPECT_EQ(encode_pnm(colour), file_of("P6\n1 1\n255\n\0\0B"sv).bytes);
    Image16 grey(2, 1, 1);
    grey.pixel(1, 0)[0] = 0x4142;
    EXPECT_EQ(encode_pnm(grey), file_of("P5\n2 1\n65535\n\0\0AB"sv).bytes);
}

TEST(Pnm, SkipsCommentsAndTakesAnyWhiteSpaceInTheHeader) {
    const auto image = decode_image(file_of("P5 # made by hand\n# twice\n\t2 1\r\n255 AB"));
    const auto samples = std::get<Image8>(image).samples();
    EXPECT_EQ(std::vector(samples.begin(), samples.end()), (std::vector<std::uint8_t>{'A', 'B'}));
}

TEST(Pnm, TakesAPixelThatLooksLikeWhiteSpace) {
    EXPECT_EQ(std::get<Image8>(decode_image(file_of("P5 1 1 255\n\n"))).pixel(0, 0)[0], '\n');
}

TEST(Pnm, RefusesEveryBeginningOfAFile) {
    std::mt19937 random(2);
    expect_no_beginning_is_read(encode_pnm(random_image<std::uint8_t>({3, 2, 3}, random)));
    expect_no_beginning_is_read(encode_pnm(random_image<std::uint16_t>({2, 3, 1}, random)));
}

TEST(Pnm, SurvivesDamage) {
    std::mt19937 random(3);
    const Bytes whole = encode_pnm(random_image<std::uint8_t>({3, 2, 3}, random));
    EXPECT_GT(refused_of_damaged(whole, 1000, 4), 0);
}

TEST(Pnm, RefusesWhatItDoesNotRead) {
    const std::string_view bad[] = {
        "P1 1 1 0",         "P3 1 1 255 0 0 0",
        "P4 1 1 A",         "P7\nWIDTH 1\n",
        "P5 1 1 254\nA",    "P5 1 1 0\nA",
        "P5 1 1 65536\nAA", "P5 -1 1 255\nA",
        "P5 +1 1 255\nA",   "P5 1.0 1 255\nA",
        "P5 1 1 255A",      "P5 1 1 255\nAB",
        "P51 1 255\nA",     "P5 0 1 255\n",
        "P5 1 0 255\n",     "P5 1 1",
        "P5 # 1 1 255\nA",  "P5 1e0 1 255\nA",
        "P5 0x1 1 255\nA",  "P5 1 99999999999999999999 255\n",
    };
    for (const auto text : bad)
        EXPECT_NE(complaint(file_of(text)), "") << text;
}

TEST(Pnm, NamesTheFileAndTheReason) {
    EXPECT_EQ(complaint(file_of("P5 1 1 1023\nAA")),
              "picture: maxval 1023: only 255 and 65535 are read");
    EXPECT_EQ(complaint(file_of("P5 1 1 255\nAAA")), "picture: 2 bytes follow the picture");
}

}  // namespace
}  // namespace scanlight::raster
