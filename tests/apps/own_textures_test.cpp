// The textures that a mesh's own materials name.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "raster/load_image.h"
#include "raster/save_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

namespace fs = std::filesystem;

/// A folder with a square that faces the eye, and a red picture.
class OwnTextures : public testing::Test {
protected:
    OwnTextures() {
        raster::Image8 red(2, 2, 3);
        for (int i = 0; i < 4; ++i)
            red.samples()[static_cast<std::size_t>(3 * i)] = 255;
        raster::save_image(shell_ / "red.png", red);
        write_square("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n", "f 1/1 2/2 3/3 4/4\n");
    }

    void write_square(const std::string& uvs, const std::string& face) const {
        shell_.write("m.obj", "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n" + uvs +
                                  "usemtl a\n" + face);
    }

    Outcome render(const std::string& statements, const std::string& options = "") const {
        shell_.write("m.mtl", "newmtl a\nKd 1 1 1\nKa 1 1 1\nillum 1\n" + statements + "\n");
        return shell_.run("scanlight render m.obj -o m.png -s 16x16 --view 0,0 --ambient 1 " +
                          options);
    }

    bool is_red() const {
        const auto image = std::get<raster::Image8>(raster::load_image(shell_ / "m.png"));
        const auto pixel = image.pixel(8, 8);
        return pixel[0] > 200 && pixel[1] == 0 && pixel[2] == 0;
    }

    void expect_left_out(const std::string& statement, const std::string& reason) const {
        const Outcome outcome = render(statement);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("scanlight: m.obj: material \"a\": " + reason), outcome.err.npos)
            << outcome.err;
        EXPECT_FALSE(is_red());
    }

    Shell shell_;
};

TEST_F(OwnTextures, AreDrawn) {
    const Outcome outcome = render("map_Kd red.png");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(is_red());
    render("map_Kd red.png", "--path textbook");
    EXPECT_TRUE(is_red());
}

TEST_F(OwnTextures, MayLieInAFolderBelow) {
    fs::create_directories(shell_ / "old pictures");
    fs::rename(shell_ / "red.png", shell_ / "old pictures/red 1.png");
    render("map_Kd -s 1 1 1 old pictures\\red 1.png");
    EXPECT_TRUE(is_red());
}

TEST_F(OwnTextures, CanBeLeftOut) {
    const Outcome outcome = render("map_Kd none.png", "--no-textures");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err.find("none.png"), outcome.err.npos) << outcome.err;
    render("map_Kd red.png", "--no-textures");
    EXPECT_FALSE(is_red());
}

TEST_F(OwnTextures, AnOptionReplacesThemSlotBySlot) {
    render("map_Kd red.png", "--texture \"diffuse=checker low=0,0,1 high=0,0,1\"");
    EXPECT_FALSE(is_red());
    render("map_Kd red.png", "--texture \"specular=checker\"");
    EXPECT_TRUE(is_red());
}

TEST_F(OwnTextures, OneThatCannotBeUsedIsLeftOut) {
    shell_.write("text.png", "hello");
    shell_.write("cut.jpg", "\xff\xd8\xff");
    ::mkfifo((shell_ / "pipe.png").c_str(), 0600);
    fs::create_symlink("/dev/zero", shell_ / "zero.png");
    expect_left_out("map_Kd none.png", "map_Kd is left out: none.png: there is no such file");
    expect_left_out("map_Kd text.png", "map_Kd is left out: text.png: not a PNG, JPEG, PPM");
    expect_left_out("map_Kd cut.jpg", "map_Kd is left out: cut.jpg: ");
    expect_left_out("map_Kd ../secret.png",
                    "map_Kd is left out: texture \"../secret.png\" is refused: it lies outside");
    expect_left_out("map_Kd /etc/passwd",
                    "map_Kd is left out: texture \"/etc/passwd\" is refused: it is an absolute");
    expect_left_out("map_Kd zero.png",
                    "map_Kd is left out: texture \"zero.png\" is refused: it is a link that leads");
    expect_left_out("map_Kd pipe.png", "map_Kd is left out: ");
    expect_left_out("map_Kd m.mtl/red.png", "map_Kd is left out: ");
}

TEST_F(OwnTextures, NeedPhongShadingAndPlacesOnThem) {
    const Outcome gouraud = render("map_Kd red.png", "--shading gouraud");
    EXPECT_EQ(gouraud.status, 0);
    EXPECT_NE(gouraud.err.find("m.obj: the textures of its materials are left out: only Phong "
                               "shading draws them"),
              gouraud.err.npos)
        << gouraud.err;
    write_square("", "f 1 2 3 4\n");
    const Outcome bare = render("map_Kd red.png");
    EXPECT_NE(bare.err.find("the mesh has no texture coordinates"), bare.err.npos) << bare.err;
}

TEST_F(OwnTextures, WhatIllumAsksForInVainIsSaid) {
    const Outcome outcome = render("illum 4");
    EXPECT_NE(outcome.err.find("scanlight: m.obj: material \"a\": illum 4: it mirrors "
                               "surroundings, if there are any, and does not refract"),
              outcome.err.npos)
        << outcome.err;
}

}  // namespace
}  // namespace scanlight::apps
