#include "raster/gif.h"

#include <gif_lib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>
#include <vector>

#include "raster/palette.h"
#include "tests/raster/cases.h"

namespace scanlight::raster {
namespace {

Image8 gradient(int width, int height, int shift) {
    Image8 image(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto pixel = image.pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(x * 255 / width);
            pixel[1] = static_cast<std::uint8_t>(y * 255 / height);
            pixel[2] = static_cast<std::uint8_t>((x + y + shift) % 256);
        }
    }
    return image;
}

int largest_error(const Image8& image, const PalettePicture& picture) {
    int largest = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            largest = std::max(largest, std::abs(image.samples()[3 * i + k] -
                                                 picture.colors[picture.pixels[i]][k]));
    }
    return largest;
}

TEST(Palette, KeepsFewColoursAsTheyAre) {
    Image8 image(16, 16, 3);
    for (int i = 0; i < 256; ++i) {
        const auto pixel = image.pixel(i % 16, i / 16);
        pixel[0] = static_cast<std::uint8_t>(i % 4 * 85);
        pixel[1] = static_cast<std::uint8_t>(i / 4 % 8 * 36);
        pixel[2] = static_cast<std::uint8_t>(i / 32 * 36);
    }
    const PalettePicture picture = with_palette(image);
    EXPECT_EQ(picture.colors.size(), 256u);
    EXPECT_EQ(largest_error(image, picture), 0);
}

TEST(Palette, OfManyColoursIsNear) {
    const Image8 image = gradient(200, 150, 0);
    const PalettePicture picture = with_palette(image);
    EXPECT_EQ(picture.colors.size(), 256u);
    EXPECT_LE(largest_error(image, picture), 40);
    EXPECT_EQ(with_palette(Image8(3, 3, 3)).colors.size(), 1u);
}

struct Source {
    const std::vector<std::uint8_t>& bytes;
    std::size_t at = 0;
};

int read_bytes(GifFileType* gif, GifByteType* to, int count) {
    auto& source = *static_cast<Source*>(gif->UserData);
    const auto size = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.at);
    std::memcpy(to, source.bytes.data() + source.at, size);
    source.at += size;
    return static_cast<int>(size);
}

TEST(Gif, HoldsTheFramesInTheirPalettes) {
    const Image8 frames[] = {gradient(60, 40, 0), gradient(60, 40, 100)};
    GifEncoder encoder({60, 40}, 4);
    for (const Image8& frame : frames)
        encoder.add(frame);
    const std::vector<std::uint8_t> bytes = encoder.finish();
    Source source{bytes};
    GifFileType* gif = DGifOpen(&source, read_bytes, nullptr);
    ASSERT_NE(gif, nullptr);
    ASSERT_EQ(DGifSlurp(gif), GIF_OK);
    ASSERT_EQ(gif->ImageCount, 2);
    for (int i = 0; i < 2; ++i) {
        const SavedImage& saved = gif->SavedImages[i];
        const PalettePicture expected = with_palette(frames[i]);
        EXPECT_TRUE(std::equal(expected.pixels.begin(), expected.pixels.end(), saved.RasterBits));
        EXPECT_EQ(saved.ImageDesc.ColorMap->Colors[5].Green, expected.colors[5][1]);
        GraphicsControlBlock block;
        ASSERT_EQ(DGifSavedExtensionToGCB(gif, i, &block), GIF_OK);
        EXPECT_EQ(block.DelayTime, 4);
    }
    EXPECT_EQ(gif->SavedImages[0].ExtensionBlocks[0].Function, APPLICATION_EXT_FUNC_CODE);
    DGifCloseFile(gif, nullptr);
}

TEST(Gif, OfTheSameFramesHasTheSameBytes) {
    std::set<std::vector<std::uint8_t>> files;
    for (int i = 0; i < 2; ++i) {
        GifEncoder encoder({50, 30}, 4);
        encoder.add(gradient(50, 30, 3));
        files.insert(encoder.finish());
    }
    EXPECT_EQ(files.size(), 1u);
}

}  // namespace
}  // namespace scanlight::raster
