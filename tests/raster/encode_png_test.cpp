#include "raster/encode_png.h"

#include <gtest/gtest.h>
#include <libdeflate.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "raster/decode_png.h"
#include "raster/image_error.h"
#include "tests/raster/random_image.h"

namespace scanlight::raster {
namespace {

// Noise, even ground and runs of every length: what a picture may hold.
template <class Sample>
Image<Sample> patchy_image(Shape shape, std::mt19937& random) {
    Image<Sample> image(shape.width, shape.height, shape.channels);
    const auto samples = image.samples();
    for (std::size_t i = 0; i < samples.size();) {
        Sample sample;
        fill_at_random(sample, random);
        const std::size_t longest = random() % 2 == 0 ? 4 : 1500;
        const std::size_t count = std::min(1 + random() % longest, samples.size() - i);
        std::ranges::fill(samples.subspan(i, count), sample);
        i += count;
    }
    return image;
}

Shape random_shape(int longest_side, std::mt19937& random) {
    const auto up_to = [&](int most) {
        return 1 + static_cast<int>(random() % static_cast<unsigned>(most));
    };
    return {up_to(longest_side), up_to(longest_side), up_to(4)};
}

template <class Sample>
Image<Sample> taken(const Sample* samples, Shape shape) {
    Image<Sample> image(shape.width, shape.height, shape.channels);
    if (samples != nullptr) std::copy_n(samples, image.samples().size(), image.samples().begin());
    return image;
}

struct Freed {
    void operator()(void* samples) const { stbi_image_free(samples); }
};

Image8 read_by_stb(const Bytes& file, const Image8&) {
    Shape shape{};
    const std::unique_ptr<stbi_uc, Freed> samples(
        stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &shape.width,
                              &shape.height, &shape.channels, 0));
    return taken(samples.get(), shape);
}

Image16 read_by_stb(const Bytes& file, const Image16&) {
    Shape shape{};
    const std::unique_ptr<stbi_us, Freed> samples(
        stbi_load_16_from_memory(file.data(), static_cast<int>(file.size()), &shape.width,
                                 &shape.height, &shape.channels, 0));
    return taken(samples.get(), shape);
}

template <class Sample>
void expect_read_back(const Image<Sample>& image) {
    const Bytes file = encode_png(image);
    EXPECT_EQ(std::get<Image<Sample>>(decode_png({"picture", file})), image);
    EXPECT_EQ(read_by_stb(file, image), image);
}

TEST(EncodePng, OtherReadersFindTheSameSamples) {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Shape shape = random_shape(i < 100 ? 9 : 90, random);
        SCOPED_TRACE(testing::Message() << shape.width << " x " << shape.height << " x "
                                        << shape.channels << ", number " << i);
        expect_read_back(random_image<std::uint8_t>(shape, random));
        expect_read_back(random_image<std::uint16_t>(shape, random));
        expect_read_back(patchy_image<std::uint8_t>(shape, random));
        expect_read_back(patchy_image<std::uint16_t>(shape, random));
    }
}

TEST(EncodePng, OtherReadersFindRowsAndColumnsOfAnyLength) {
    std::mt19937 random(2);
    for (const Shape shape : {Shape{16384, 1, 4}, {1, 16384, 4}, {16384, 3, 1}, {1, 1, 2}}) {
        expect_read_back(patchy_image<std::uint8_t>(shape, random));
        expect_read_back(patchy_image<std::uint16_t>(shape, random));
    }
}

// Noise does not pack: these fill one chunk, and some.
TEST(EncodePng, OtherReadersCrossFromChunkToChunk) {
    std::mt19937 random(3);
    expect_read_back(random_image<std::uint8_t>({16384, 43, 3}, random));
    expect_read_back(random_image<std::uint16_t>({701, 999, 2}, random));
}

TEST(EncodePng, TheSamePictureGivesTheSameBytes) {
    std::mt19937 random(4);
    const auto image = patchy_image<std::uint8_t>({701, 999, 3}, random);
    const auto depth = patchy_image<std::uint16_t>({701, 999, 1}, random);
    EXPECT_EQ(encode_png(Image8(image)), encode_png(image));
    EXPECT_EQ(encode_png(Image16(depth)), encode_png(depth));
}

TEST(EncodePng, EvenGroundTakesHardlyAnyBytes) {
    EXPECT_LT(encode_png(Image8(1920, 1080, 3)).size(), 12000u);
}

TEST(EncodePng, NoiseGrowsByLessThanAHundredth) {
    std::mt19937 random(5);
    const auto noise = random_image<std::uint8_t>({640, 480, 3}, random);
    EXPECT_LT(encode_png(noise).size(), noise.samples().size() * 101 / 100);
}

TEST(EncodePng, RefusesPicturesThatNobodyReads) {
    EXPECT_THROW(encode_png(Image8()), ImageError);
    EXPECT_THROW(encode_png(Image16(0, 7, 1)), ImageError);
    EXPECT_THROW(encode_png(Image8(1000001, 1, 1)), ImageError);
    EXPECT_NO_THROW(encode_png(Image8(1000000, 1, 1)));
}

TEST(EncodePng, SaysThatMemoryRanOut) {
    const auto no_memory = [](std::size_t) -> void* { return nullptr; };
    libdeflate_set_memory_allocator(no_memory, std::free);
    EXPECT_THROW(encode_png(Image8(1, 1, 1)), ImageError);
    libdeflate_set_memory_allocator(std::malloc, std::free);
    EXPECT_NO_THROW(encode_png(Image8(1, 1, 1)));
}

}  // namespace
}  // namespace scanlight::raster
