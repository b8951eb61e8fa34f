#include "mesh/mesh_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "mesh/load.h"
#include "tests/mesh/reading.h"
#include "tests/raster/temporary_folder.h"

namespace scanlight::mesh {
namespace {

namespace fs = std::filesystem;
using raster::put;
using raster::TemporaryFolder;

/// A folder with a mesh in `models`, libraries in and below it, and secrets around it.
class MeshFolder : public testing::Test {
protected:
    MeshFolder() {
        fs::create_directories(folder_ / "models/sub");
        fs::create_directories(folder_ / "models2");
        for (const char* name : {"models/a.mtl", "models/sub/b.mtl", "models/c d.mtl", "secret.mtl",
                                 "models2/e.mtl"}) {
            put(folder_ / name, "newmtl a\nKd 1 0 0\n");
        }
        fs::create_symlink("a.mtl", folder_ / "models/inside.mtl");
        fs::create_symlink("../secret.mtl", folder_ / "models/outside.mtl");
        fs::create_symlink("..", folder_ / "models/up");
        fs::create_symlink("/dev/zero", folder_ / "models/zero.mtl");
        ::mkfifo((folder_ / "models/pipe.mtl").c_str(), 0600);
    }

    PolygonSoup load_naming(const std::string& library) {
        put(folder_ / "models/m.obj",
            "mtllib " + library + "\n" + obj_triangle + "usemtl a\nf 1 2 3\n");
        return load(folder_ / "models/m.obj");
    }

    TemporaryFolder folder_;
};

TEST_F(MeshFolder, OpensWhatLiesInIt) {
    for (const std::string name :
         {"a.mtl", "./a.mtl", "sub/b.mtl", "sub\\b.mtl", "c d.mtl", "inside.mtl", "a.mtl sub/b.mtl",
          "none.mtl a.mtl", "  a.mtl  ", "sub//b.mtl"}) {
        EXPECT_EQ(load_naming(name).materials.at(0).diffuse, glm::vec3(1, 0, 0)) << name;
    }
}

TEST_F(MeshFolder, RefusesWhatLiesOutside) {
    const std::string secret = folder_ / "secret.mtl";
    for (const std::string& name :
         {std::string("../secret.mtl"), std::string("../../../../dev/zero"),
          std::string("sub/../../secret.mtl"), std::string("sub/../a.mtl"),
          std::string("..\\secret.mtl"), std::string(".."), secret, std::string("/dev/zero"),
          std::string("/etc/passwd"), std::string("//etc/passwd"), std::string("\\etc\\passwd"),
          std::string("C:\\a.mtl"), std::string("c:a.mtl"), std::string("outside.mtl"),
          std::string("up/secret.mtl"), std::string("up/models2/e.mtl"), std::string("zero.mtl"),
          std::string("a.mtl ../secret.mtl"), std::string("a.mtl /etc/passwd")}) {
        const std::string error = error_of([&] { load_naming(name); });
        EXPECT_TRUE(error.starts_with((folder_ / "models/m.obj") + ":1: material library "))
            << name << error;
        EXPECT_NE(error.find(" is refused: "), error.npos) << name << error;
    }
}

TEST_F(MeshFolder, RefusesWhatIsNoFile) {
    for (const std::string name : {"pipe.mtl", "sub", "."}) {
        const std::string error = error_of([&] { load_naming(name); });
        EXPECT_TRUE(error.starts_with((folder_ / "models/m.obj") + ":1: ")) << name;
        EXPECT_NE(error.find(": is a "), error.npos) << name << error;
    }
}

TEST_F(MeshFolder, AMissingLibraryIsAWarning) {
    const PolygonSoup soup = load_naming("none.mtl");
    EXPECT_EQ(soup.face_count(), 1u);
    EXPECT_EQ(soup.warnings.at(0), (folder_ / "models/m.obj") +
                                       ":1: material library \"none.mtl\" is not there: default "
                                       "materials take its place");
}

TEST_F(MeshFolder, AMistakeInALibraryNamesTheLibrary) {
    put(folder_ / "models/bad.mtl", "newmtl a\nKd red\n");
    EXPECT_EQ(error_of([&] { load_naming("bad.mtl"); }), "bad.mtl:2: \"red\" is not a number");
}

TEST_F(MeshFolder, TheFirstMaterialOfANameIsTaken) {
    put(folder_ / "models/again.mtl", "newmtl a\nKd 0 0 1\nnewmtl z\n");
    const PolygonSoup soup = load_naming("a.mtl again.mtl");
    EXPECT_EQ(soup.materials.at(0).diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(
        soup.warnings.at(0),
        (folder_ / "models/m.obj") + ": 1 material is defined again: the first of a name is taken");
}

TEST(Libraries, EachIsReadOnceAndTheyHaveABound) {
    int opened = 0;
    const OpenFile open = [&](std::string_view) -> std::optional<Bytes> {
        ++opened;
        return Bytes();
    };
    std::string text;
    for (int i = 0; i < 1000; ++i)
        text += "mtllib same.mtl\n";
    load_obj(text, "file", open);
    EXPECT_EQ(opened, 1);
    for (int i = 0; i < 100; ++i)
        text += "mtllib " + std::to_string(i) + "\n";
    EXPECT_EQ(error_of([&] { load_obj(text, "file", open); }),
              "file:1064: one material library too many");
}

}  // namespace
}  // namespace scanlight::mesh
