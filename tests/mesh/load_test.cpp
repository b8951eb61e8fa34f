#include "mesh/load.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "mesh/file_format.h"
#include "tests/mesh/reading.h"
#include "tests/raster/temporary_folder.h"

namespace scanlight::mesh {
namespace {

using raster::put;
using raster::TemporaryFolder;

const std::string obj_text = obj_triangle + "f 1 2 3\n";
const std::string off_text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string ply_text = text_ply(ply_points + ply_faces, ply_triangle);
const std::string stl_text =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid\n";
const std::string stl_bytes = binary_stl(1, stl_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));

TEST(Load, TellsTheFormatByContentWhateverTheEnding) {
    const TemporaryFolder folder;
    for (const std::string& bytes : {obj_text, off_text, ply_text, stl_text, stl_bytes}) {
        for (const char* name : {"a", "a.obj", "a.off", "a.ply", "a.STL", "a.txt"}) {
            put(folder / name, bytes);
            EXPECT_EQ(load(folder / name).face_count(), 1u) << name;
        }
    }
}

TEST(Load, TellsTheFormatByTheEndingWhereContentIsSilent) {
    EXPECT_EQ(format_of("3 1 0\n", "a.off"), FileFormat::off);
    EXPECT_EQ(format_of("hello\nv 0 0 0\n", "a.OBJ"), FileFormat::obj);
    EXPECT_EQ(format_of(std::string(90, 'x'), "x/a.b.stl"), FileFormat::stl);
    EXPECT_EQ(format_of("hello", "a.Ply"), FileFormat::ply);
    EXPECT_EQ(format_of("hello", "obj"), std::nullopt);
    EXPECT_EQ(format_of("OFFICE", "a"), std::nullopt);
    EXPECT_EQ(format_of("# c\nSTCNOFF\n", "a.obj"), FileFormat::off);
    EXPECT_EQ(format_of("# c\n\n  mtllib a\n", "a"), FileFormat::obj);
}

TEST(Load, WhatCannotBeReadGetsOneClearMessage) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& path) { return error_of([&] { load(path); }); };
    put(folder / "empty.obj", "");
    EXPECT_EQ(error(folder / "empty.obj"), (folder / "empty.obj") + ": is empty");
    put(folder / "a.txt", "hello\n");
    EXPECT_EQ(error(folder / "a.txt"), (folder / "a.txt") + ": is neither OBJ, PLY, OFF nor STL");
    EXPECT_EQ(error(folder / "none.obj"),
              (folder / "none.obj") + ": cannot be opened: No such file or directory");
    EXPECT_EQ(error(folder / ""), (folder / "") + ": is a folder");
    EXPECT_EQ(error("/dev/zero"), "/dev/zero: is a device, not a file or pipe");
    EXPECT_EQ(error("/dev/null"), "/dev/null: is a device, not a file or pipe");
    EXPECT_EQ(error(""), ": cannot be opened: No such file or directory");
    put(folder / "bad.obj", obj_triangle + "f 1 2 99\n");
    EXPECT_EQ(
        error(folder / "bad.obj"),
        (folder / "bad.obj") + ":4: vertex index 99 is out of range: the file has 3 vertices");
}

TEST(Load, AFileTooLargeIsRefusedBeforeItIsRead) {
    const TemporaryFolder folder;
    put(folder / "huge.obj", "v 0 0 0\n");
    std::filesystem::resize_file(folder / "huge.obj", max_file_bytes + 1);  // sparse
    EXPECT_EQ(error_of([&] { load(folder / "huge.obj"); }),
              (folder / "huge.obj") + ": is larger than 2048 MiB");
}

TEST(Load, ReadsAPipeToItsEnd) {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string text = obj_triangle;  // more than a pipe and the first piece hold
    for (int i = 0; i < 50000; ++i)
        text += "f 1 2 3\n";
    std::thread writer([&] { put(pipe, text); });
    const PolygonSoup soup = load(pipe);
    writer.join();
    EXPECT_EQ(soup.face_count(), 50000u);
}

/// Puts a file in the place of standard input for a while.
class StandardInput {
public:
    explicit StandardInput(const std::string& path) : saved_(::dup(STDIN_FILENO)) {
        if (std::freopen(path.c_str(), "rb", stdin) == nullptr) throw std::runtime_error(path);
    }
    ~StandardInput() {
        ::dup2(saved_, STDIN_FILENO);
        ::close(saved_);
    }
    StandardInput(const StandardInput&) = delete;
    StandardInput& operator=(const StandardInput&) = delete;

private:
    int saved_;
};

TEST(Load, ADashIsStandardInputAndHasNoLibraries) {
    const TemporaryFolder folder;
    put(folder / "a.obj", "mtllib a.mtl\n" + obj_triangle + "usemtl a\nf 1 2 3\n");
    const StandardInput input(folder / "a.obj");
    const PolygonSoup soup = load("-");
    EXPECT_EQ(soup.face_count(), 1u);
    EXPECT_EQ(soup.warnings.at(0),
              "standard input:1: material library \"a.mtl\" is not there: default materials take "
              "its place");
}

TEST(Load, StandardInputMustBeAFileOrPipe) {
    const StandardInput input("/dev/zero");
    EXPECT_EQ(error_of([] { load("-"); }), "standard input: is a device, not a file or pipe");
}

}  // namespace
}  // namespace scanlight::mesh
