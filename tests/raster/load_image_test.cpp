#include "raster/load_image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "raster/save_image.h"
#include "tests/raster/bad_bytes.h"
#include "tests/raster/handmade_png.h"
#include "tests/raster/random_image.h"
#include "tests/raster/temporary_folder.h"

namespace scanlight::raster {
namespace {

std::string load_complaint(const std::string& path) {
    try {
        load_image(path);
        return {};
    } catch (const ImageError& error) {
        return error.what();
    }
}

std::string save_complaint(const std::string& path, const AnyImage& image) {
    try {
        save_image(path, image);
        return {};
    } catch (const ImageError& error) {
        return error.what();
    }
}

std::string netpbm(const std::string& size) {
    return "P6 " + size + " 65535\n";
}
std::string pfm(const std::string& size) {
    return "PF " + size + " -1\n";
}
std::string hdr(const std::string& size) {
    return "#?RADIANCE\n\n" + size + "\n";
}

TEST(LoadImage, TellsFilesByContentAndNotByName) {
    std::mt19937 random(1);
    const TemporaryFolder folder;
    const AnyImage picture = random_image<std::uint8_t>({5, 3, 3}, random);
    save_image(folder / "a.ppm", picture);
    std::filesystem::rename(folder / "a.ppm", folder / "a.png");
    EXPECT_EQ(load_image(folder / "a.png"), picture);
}

TEST(LoadImage, ReadsEveryFormatThatIsWritten) {
    std::mt19937 random(2);
    const TemporaryFolder folder;
    const AnyImage whole = random_image<std::uint8_t>({9, 3, 3}, random);
    const AnyImage depth = random_image<std::uint16_t>({9, 3, 1}, random);
    const AnyImage floats = random_image<float>({9, 3, 1}, random);
    for (const auto* name : {"a.png", "a.ppm", "A.PGM"}) {
        save_image(folder / name, whole);
        EXPECT_EQ(load_image(folder / name), whole) << name;
        save_image(folder / name, depth);
        EXPECT_EQ(load_image(folder / name), depth) << name;
    }
    save_image(folder / "a.pfm", floats);
    EXPECT_EQ(load_image(folder / "a.pfm"), floats);
    save_image(folder / "a.hdr", floats);
    EXPECT_EQ(std::get<ImageF>(load_image(folder / "a.hdr")).width(), 9);
}

TEST(LoadImage, RefusesHugeSizesBeforeItTakesMemory) {
    rusage before;
    getrusage(RUSAGE_SELF, &before);
    for (const auto* size :
         {"16384 16384", "16385 1", "1 16385", "1000000 1000000", "4294967296 4294967296",
          "9223372036854775807 2", "99999999999999999999 1", "6000 8000", "5000 4000"}) {
        EXPECT_NE(complaint(file_of(netpbm(size))), "") << size;
        EXPECT_NE(complaint(file_of(pfm(size))), "") << size;
    }
    for (const auto* size : {"-Y 16384 +X 16384", "-Y 16385 +X 1", "-Y 1 +X 16385",
                             "-Y 4294967296 +X 4294967296", "-Y 4000 +X 4000"}) {
        EXPECT_NE(complaint(file_of(hdr(size))), "") << size;
    }
    for (const PngHeader& header :
         {PngHeader{16384, 16384, 8, rgb}, PngHeader{16384, 16384, 1, grey},
          PngHeader{16385, 1, 8, grey}, PngHeader{1, 16385, 8, grey},
          PngHeader{0x7fffffff, 0x7fffffff, 16, rgb}, PngHeader{0xffffffff, 1, 8, grey},
          PngHeader{0, 1, 8, grey}, PngHeader{8000, 8000, 8, rgb}}) {
        EXPECT_NE(complaint(handmade_png(header, "A")), "") << header.width;
    }
    rusage after;
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 * 1024);  // KiB
}

// 6 bytes a pixel: 2^28 bytes are 16384 x 2730 and two thirds.
TEST(LoadImage, TakesPicturesUpToTheLimitAndNotBeyond) {
    EXPECT_EQ(complaint(file_of(netpbm("16384 2730"))), "picture: the file ends too early");
    EXPECT_EQ(complaint(file_of(netpbm("16384 2731"))),
              "picture: 16384 x 2731 pixels take more than 256 MiB");
    EXPECT_EQ(complaint(file_of(netpbm("1 16384"))), "picture: the file ends too early");
}

TEST(LoadImage, SaysWhichLimitIsPassed) {
    EXPECT_EQ(complaint(file_of(pfm("16385 1"))),
              "picture: 16385 x 1 pixels: a side is longer than 16384");
    EXPECT_EQ(complaint(file_of(pfm("16384 16384"))),
              "picture: 16384 x 16384 pixels take more than 256 MiB");
    EXPECT_EQ(complaint(file_of(pfm("0 1"))), "picture: 0 x 1 pixels: there is nothing in it");
}

TEST(LoadImage, RefusesWhatIsNoPicture) {
    for (const auto* text : {"", "P", "P0", "P8 1 1", "\x89", "GIF89a", "#", "hello"}) {
        EXPECT_EQ(complaint(file_of(text)),
                  "picture: not a PNG, JPEG, PPM, PGM, PFM or Radiance HDR picture");
    }
}

TEST(LoadImage, NamesAFileThatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_EQ(load_complaint(folder / "none.png"),
              folder / "none.png" + ": cannot be read: No such file or directory");
    EXPECT_EQ(load_complaint("/"), "/: cannot be read: Is a directory");
}

TEST(LoadImage, EndlessDevicesEnd) {
    EXPECT_EQ(load_complaint("/dev/zero"), "/dev/zero: the file is too large");
}

TEST(SaveImage, ListsTheEndingsItKnows) {
    const std::string known =
        ": unknown kind of picture; these endings are known: .png .ppm .pgm .pfm .hdr";
    for (const std::string path : {"out.jpg", "out", "png", "out.png.txt", ""}) {
        EXPECT_EQ(save_complaint(path, Image8(1, 1, 1)), path + known);
    }
}

TEST(SaveImage, ChoosesByTheEndingInAnyCase) {
    EXPECT_EQ(image_format("a.PNG"), ImageFormat::png);
    EXPECT_EQ(image_format("b/a.png.ppm"), ImageFormat::pnm);
    EXPECT_EQ(image_format("a.Pgm"), ImageFormat::pnm);
    EXPECT_EQ(image_format("a.pfm"), ImageFormat::pfm);
    EXPECT_EQ(image_format("a.hdr"), ImageFormat::hdr);
    EXPECT_EQ(image_format(".hdr"), ImageFormat::hdr);
    EXPECT_EQ(image_format("-"), ImageFormat::pnm);
}

TEST(SaveImage, RefusesWhatTheFormatDoesNotHold) {
    const TemporaryFolder folder;
    EXPECT_NE(save_complaint(folder / "a.png", ImageF(1, 1, 3)), "");
    EXPECT_NE(save_complaint(folder / "a.ppm", ImageF(1, 1, 3)), "");
    EXPECT_NE(save_complaint(folder / "a.pfm", Image8(1, 1, 3)), "");
    EXPECT_NE(save_complaint(folder / "a.hdr", Image16(1, 1, 3)), "");
    EXPECT_NE(save_complaint(folder / "a.ppm", Image8(1, 1, 4)), "");
    EXPECT_NE(save_complaint(folder / "a.pfm", ImageF(1, 1, 2)), "");
    EXPECT_NE(save_complaint(folder / "a.png", Image8(0, 5, 3)), "");
    EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace scanlight::raster
