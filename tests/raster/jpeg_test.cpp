#include "raster/decode_jpeg.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include <jpeglib.h>

#include "tests/raster/bad_bytes.h"

namespace scanlight::raster {
namespace {

struct Sheet {
    int width = 16;
    int height = 16;
    std::vector<std::uint8_t> samples;  // one channel after the other in each pixel
};

using Settings = std::function<void(jpeg_compress_struct&)>;

/// Written by libjpeg, of samples in this colour space.
Bytes jpeg_of(Sheet sheet, J_COLOR_SPACE space, const Settings& settings = {}) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &data, &size);
    jpeg.image_width = static_cast<unsigned>(sheet.width);
    jpeg.image_height = static_cast<unsigned>(sheet.height);
    jpeg.in_color_space = space;
    jpeg.input_components = static_cast<int>(sheet.samples.size()) / (sheet.width * sheet.height);
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (settings) settings(jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    while (jpeg.next_scanline < jpeg.image_height) {
        JSAMPROW row = sheet.samples.data() + jpeg.next_scanline * jpeg.image_width *
                                                  static_cast<unsigned>(jpeg.input_components);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    Bytes bytes(data, data + size);
    std::free(data);
    return bytes;
}

/// Slopes of other steepness in each channel.
Sheet slopes(int width, int height, int channels) {
    Sheet sheet{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c)
                sheet.samples.push_back(static_cast<std::uint8_t>(40 + 2 * c * x + (4 - c) * y));
        }
    }
    return sheet;
}

/// One colour all over.
Sheet plain(const std::vector<std::uint8_t>& color) {
    Sheet sheet;
    for (int i = 0; i < sheet.width * sheet.height; ++i)
        sheet.samples.insert(sheet.samples.end(), color.begin(), color.end());
    return sheet;
}

Image8 read(const Bytes& bytes) {
    return std::get<Image8>(decode_image({"picture", bytes}));
}

std::vector<int> color_of(const Image8& image) {
    const auto pixel = image.pixel(5, 3);
    return {pixel.begin(), pixel.end()};
}

int worst_difference(const Image8& image, const Sheet& sheet) {
    int worst = 0;
    for (std::size_t i = 0; i < sheet.samples.size(); ++i)
        worst = std::max(worst, std::abs(int(image.samples()[i]) - int(sheet.samples[i])));
    return worst;
}

void progressive(jpeg_compress_struct& jpeg) {
    jpeg_simple_progression(&jpeg);
}
void whole_chroma(jpeg_compress_struct& jpeg) {
    for (int c = 0; c < 3; ++c)
        jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
}

/// The bytes after marker 0xFF `marker`.
std::size_t after_marker(const Bytes& bytes, std::uint8_t marker) {
    for (std::size_t i = 2; i + 1 < bytes.size(); ++i) {
        if (bytes[i] == 0xff && bytes[i + 1] == marker) return i + 2;
    }
    ADD_FAILURE() << "no such marker";
    return 0;
}

/// Another size in the frame header.
Bytes declaring(Bytes bytes, int width, int height) {
    std::size_t at = after_marker(bytes, 0xc0) + 3;
    for (const int side : {height, width}) {
        bytes[at++] = static_cast<std::uint8_t>(side >> 8);
        bytes[at++] = static_cast<std::uint8_t>(side & 0xff);
    }
    return bytes;
}

TEST(Jpeg, ReadsGreyAndColoursWithinTheirRounding) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {8, 8}, {17, 9}, {33, 31}}) {
        const Sheet grey = slopes(width, height, 1);
        const Image8 image = read(jpeg_of(grey, JCS_GRAYSCALE));
        EXPECT_EQ(image.channels(), 1);
        EXPECT_LE(worst_difference(image, grey), 1);
        const Sheet colors = slopes(width, height, 3);
        EXPECT_LE(worst_difference(read(jpeg_of(colors, JCS_RGB, whole_chroma)), colors), 3);
    }
}

TEST(Jpeg, ProgressiveIsTheSamePicture) {
    const Sheet sheet = slopes(33, 20, 3);
    EXPECT_EQ(read(jpeg_of(sheet, JCS_RGB, progressive)), read(jpeg_of(sheet, JCS_RGB)));
}

// A cosine transform or a smoothing of another kind would show here. Red and blue, 8 columns each,
// whose chroma is halved: it is repeated, not mixed, so that each side is one colour.
TEST(Jpeg, ChromaIsRepeatedAndNotSmoothed) {
    Sheet sheet = plain({200, 40, 60});
    for (std::size_t i = 0; i < sheet.samples.size(); i += 3) {
        if (i / 3 % 16 >= 8) std::swap(sheet.samples[i], sheet.samples[i + 2]);
    }
    const Image8 image = read(jpeg_of(sheet, JCS_RGB));
    for (int x = 0; x < 16; ++x) {
        const auto pixel = image.pixel(x, 7);
        const int expected[] = {x < 8 ? 200 : 60, 40, x < 8 ? 60 : 200};
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(pixel[c], expected[c], 4) << x;
    }
}

TEST(Jpeg, InkBecomesLight) {
    const auto plain_ink = [](jpeg_compress_struct& jpeg) { jpeg.write_Adobe_marker = FALSE; };
    const Sheet ink = plain({0, 255, 128, 51});
    EXPECT_EQ(color_of(read(jpeg_of(ink, JCS_CMYK, plain_ink))), (std::vector{204, 0, 102}));
    // Adobe's programs count what is left white.
    EXPECT_EQ(color_of(read(jpeg_of(ink, JCS_CMYK))), (std::vector{0, 51, 26}));
    const auto as_ycck = [](jpeg_compress_struct& jpeg) { jpeg_set_colorspace(&jpeg, JCS_YCCK); };
    EXPECT_EQ(read(jpeg_of(ink, JCS_CMYK, as_ycck)).channels(), 3);
}

TEST(Jpeg, NothingMayBeMissing) {
    expect_no_beginning_is_read(jpeg_of(slopes(9, 9, 1), JCS_GRAYSCALE));
    expect_no_beginning_is_read(jpeg_of(slopes(17, 9, 3), JCS_RGB));
    expect_no_beginning_is_read(jpeg_of(slopes(17, 9, 3), JCS_RGB, progressive));
}

TEST(Jpeg, DamagedFilesAreReadOrRefused) {
    const Bytes whole = jpeg_of(slopes(40, 30, 3), JCS_RGB);
    EXPECT_GT(refused_of_damaged(whole, 2000, 1), 100);
    EXPECT_GT(refused_of_damaged(jpeg_of(slopes(40, 30, 3), JCS_RGB, progressive), 2000, 2), 100);
}

TEST(Jpeg, SaysWhatIsWrong) {
    const Bytes whole = jpeg_of(slopes(16, 16, 3), JCS_RGB);
    const auto cut = [&](std::size_t size) {
        return complaint({"a.jpg", {whole.begin(), whole.begin() + std::ptrdiff_t(size)}});
    };
    EXPECT_EQ(cut(whole.size() - 1), "a.jpg: the file ends too early");
    EXPECT_EQ(cut(30), "a.jpg: the file ends too early");
    Bytes precise = whole;
    precise[after_marker(precise, 0xc0) + 2] = 12;
    EXPECT_NE(complaint({"a.jpg", precise}), "");  // libjpeg before version 3 has its own words
    Bytes arithmetic = whole;
    arithmetic[after_marker(arithmetic, 0xc0) - 1] = 0xc9;
    EXPECT_EQ(complaint({"a.jpg", arithmetic}),
              "a.jpg: arithmetic coding is not read; Huffman's is");
    const auto unknown = [](jpeg_compress_struct& jpeg) {
        jpeg_set_colorspace(&jpeg, JCS_UNKNOWN);
    };
    EXPECT_EQ(complaint({"a.jpg", jpeg_of(plain({1, 2}), JCS_UNKNOWN, unknown)}),
              "a.jpg: 2 channels; 1, 3 or 4 are read");
    EXPECT_EQ(complaint({"a.jpg", {0xff, 0xd8, 0xff, 0xd9}}),
              "a.jpg: JPEG datastream contains no image");
}

TEST(Jpeg, RefusesHugeSizesBeforeItTakesMemory) {
    const Bytes small = jpeg_of(slopes(16, 16, 3), JCS_RGB);
    rusage before;
    getrusage(RUSAGE_SELF, &before);
    EXPECT_EQ(complaint({"a.jpg", declaring(small, 16385, 1)}),
              "a.jpg: 16385 x 1 pixels: a side is longer than 16384");
    EXPECT_EQ(complaint({"a.jpg", declaring(small, 16384, 16384)}),
              "a.jpg: 16384 x 16384 pixels take more than 256 MiB");
    EXPECT_EQ(complaint({"a.jpg", declaring(small, 9000, 9000)}), "a.jpg: the file ends too early");
    EXPECT_NE(complaint({"a.jpg", declaring(small, 0, 1)}), "");
    rusage after;
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 * 1024);  // KiB
}

TEST(Jpeg, ScansHaveABound) {
    const auto many = [](jpeg_compress_struct& jpeg) {
        static jpeg_scan_info scans[110];
        int count = 0;
        scans[count++] = {1, {0}, 0, 0, 0, 10};
        for (int bit = 10; bit > 0; --bit)
            scans[count++] = {1, {0}, 0, 0, bit, bit - 1};
        for (int k = 1; k < 64; ++k)
            scans[count++] = {1, {0}, k, k, 0, 1};
        for (int k = 1; k < 36; ++k)
            scans[count++] = {1, {0}, k, k, 1, 0};
        jpeg.scan_info = scans;
        jpeg.num_scans = count;
    };
    EXPECT_EQ(complaint({"a.jpg", jpeg_of(slopes(16, 16, 1), JCS_GRAYSCALE, many)}),
              "a.jpg: it has too many scans");
}

// A progressive file with halved chroma, and what libjpeg-turbo 2.1.5 made of it on x86-64.
TEST(Jpeg, TheSameBitsEverywhere) {
    const std::string folder = SCANLIGHT_TESTS_DIR "/raster/";
    EXPECT_EQ(load_image(folder + "rings.jpg"), load_image(folder + "rings.png"));
}

}  // namespace
}  // namespace scanlight::raster
