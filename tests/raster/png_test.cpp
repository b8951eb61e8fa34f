#include "raster/decode_png.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "raster/encode_png.h"
#include "tests/raster/bad_bytes.h"
#include "tests/raster/handmade_png.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

using namespace std::string_literals;

template <class Sample>
std::vector<Sample> samples_of(const AnyImage& image) {
    const auto samples = std::get<Image<Sample>>(image).samples();
    return {samples.begin(), samples.end()};
}

template <class Sample>
void expect_round_trip(Shape shape, std::mt19937& random) {
    const auto image = random_image<Sample>(shape, random);
    const AnyImage read = decode_image({"picture", encode_png(image)});
    ASSERT_TRUE(std::holds_alternative<Image<Sample>>(read));
    EXPECT_EQ(std::get<Image<Sample>>(read), image) << shape.width << " x " << shape.height;
}

TEST(Png, ReadsWhatItWrote) {
    std::mt19937 random(1);
    for (Shape shape : odd_sizes) {
        for (shape.channels = 1; shape.channels <= 4; ++shape.channels) {
            expect_round_trip<std::uint8_t>(shape, random);
            expect_round_trip<std::uint16_t>(shape, random);
        }
    }
}

TEST(Png, KeepsAll65536ValuesOfDepth) {
    Image16 depth(256, 256, 1);
    for (std::size_t i = 0; i < 65536; ++i)
        depth.samples()[i] = static_cast<std::uint16_t>(i);
    EXPECT_EQ(std::get<Image16>(decode_image({"depth", encode_png(depth)})), depth);
}

TEST(Png, ReadsBigEndianSamples) {
    const auto file = handmade_png({2, 1, 16, grey}, "\0\x12\x34\xff\xfe"s);
    EXPECT_EQ(samples_of<std::uint16_t>(decode_image(file)),
              (std::vector<std::uint16_t>{0x1234, 0xfffe}));
}

TEST(Png, SpreadsPalettesAndTheirTransparency) {
    const std::string palette = png_chunk("PLTE", "abcdefghi"s) + png_chunk("tRNS", "\x10\x20"s);
    const auto file = handmade_png({3, 1, 2, indexed}, "\0\x18"s, palette);  // indices 0, 1, 2
    const std::string pixels =
        "abc\x10"
        "def\x20"
        "ghi\xff";
    EXPECT_EQ(samples_of<std::uint8_t>(decode_image(file)),
              std::vector<std::uint8_t>(pixels.begin(), pixels.end()));
}

TEST(Png, SpreadsSingleBitsOverTheWholeRange) {
    const auto file = handmade_png({3, 1, 1, grey}, "\0\xa0"s);
    EXPECT_EQ(samples_of<std::uint8_t>(decode_image(file)),
              (std::vector<std::uint8_t>{255, 0, 255}));
}

TEST(Png, UntanglesInterlacedRows) {
    const std::string passes =
        "\0\1"s + "\0\3"s + "\0\2"s + "\0\4\5\6"s;  // the 1st, 4th, 6th and 7th
    const auto file = handmade_png({3, 2, 8, grey, interlaced}, passes);
    EXPECT_EQ(samples_of<std::uint8_t>(decode_image(file)),
              (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST(Png, RefusesAWrongChecksumOfWhatChangesPixels) {
    std::string transparency = png_chunk("tRNS", "\0A"s);
    EXPECT_EQ(complaint(handmade_png({1, 1, 8, grey}, "\0A"s, transparency)), "");
    transparency.back() ^= 1;
    EXPECT_NE(complaint(handmade_png({1, 1, 8, grey}, "\0A"s, transparency)), "");
}

TEST(Png, ConvertsNoColour) {
    const std::string gamma = png_chunk("gAMA", "\0\x01\x86\xa0"s);  // 1.0
    const auto file = handmade_png({2, 1, 8, grey}, "\0\x40\x80"s, gamma);
    EXPECT_EQ(samples_of<std::uint8_t>(decode_image(file)),
              (std::vector<std::uint8_t>{0x40, 0x80}));
}

TEST(Png, UnpacksNoTexts) {
    const std::string bomb = png_chunk("zTXt", "Comment\0\0"s + packed_letters(28000));
    std::string bombs;
    for (int i = 0; i < 60; ++i)
        bombs += bomb;
    rusage before;
    getrusage(RUSAGE_SELF, &before);
    EXPECT_EQ(complaint(handmade_png({1, 1, 8, grey}, "\0A"s, bombs)), "");
    rusage after;
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024);  // KiB; unpacked they are 430 MiB
}

TEST(Png, RefusesEveryBeginningOfAFile) {
    std::mt19937 random(2);
    expect_no_beginning_is_read(encode_png(random_image<std::uint8_t>({3, 2, 3}, random)));
    expect_no_beginning_is_read(encode_png(random_image<std::uint16_t>({3, 2, 1}, random)));
}

TEST(Png, RefusesEveryTurnedBitBehindTheSignature) {
    std::mt19937 random(3);
    const Bytes whole = encode_png(random_image<std::uint8_t>({5, 4, 3}, random));
    for (std::size_t bit = 8 * 8; bit < 8 * whole.size(); ++bit) {
        EncodedImage file{"damaged", whole};
        file.bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        EXPECT_NE(complaint(file), "") << "bit " << bit;
    }
}

TEST(Png, SurvivesDamageUnderRightChecksums) {
    std::mt19937 random(4);
    for (int i = 0; i < 2000; ++i) {
        std::string rows(8, '\0');
        for (char& byte : rows)
            byte = static_cast<char>(random() & 0xff);
        const auto below = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
        const PngHeader header{1 + below(3), 1 + below(3), 1u << below(5), below(7)};
        complaint(handmade_png(header, rows, png_chunk("PLTE", rows.substr(0, 6))));
    }
}

TEST(Png, RefusesAPictureOfTooFewRows) {
    EXPECT_NE(complaint(handmade_png({2, 2, 8, grey}, "\0AB"s)), "");
    EXPECT_NE(complaint(handmade_png({2, 2, 8, grey}, "\0AB\0A"s)), "");
    EXPECT_EQ(complaint(handmade_png({2, 2, 8, grey}, "\0AB\0AB"s)), "");
}

TEST(Png, SaysWhatIsWrong) {
    EXPECT_EQ(complaint(file_of("\x89PNG\r\n\x1a\n")), "picture: the file ends too early");
    EXPECT_EQ(complaint(handmade_png({16384, 16384, 8, grey}, "\0"s)),
              "picture: the file ends too early");
}

}  // namespace
}  // namespace scanlight::raster
