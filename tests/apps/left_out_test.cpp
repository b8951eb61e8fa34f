// What a picture does not show of its surfaces is said.
#include <gtest/gtest.h>

#include "raster/load_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

std::string said(const Shell& shell, const std::string& arguments) {
    const Outcome outcome = shell.run("scanlight render " + arguments + " -s 16x16 -o p.png");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
}

constexpr const char* checker = " --texture \"diffuse=checker mapping=spherical\"";

TEST(LeftOut, TexturesThatOnlyPhongShadingDraws) {
    const Shell shell;
    for (const std::string shading : {"flat", "gouraud"}) {
        const std::string err = said(shell, std::string("sphere --shading ") + shading + checker);
        EXPECT_NE(err.find("scanlight: sphere: the textures are left out: only Phong"), err.npos)
            << err;
    }
    EXPECT_EQ(said(shell, std::string("sphere") + checker).find("left out"), std::string::npos);
}

TEST(LeftOut, TheColourIsThenTheMaterialsOwn) {
    const Shell shell;
    said(shell, "sphere --shading gouraud -q");
    const auto plain = std::get<raster::Image8>(raster::load_image(shell / "p.png"));
    said(shell, std::string("sphere --shading gouraud -q") + checker);
    EXPECT_TRUE(std::get<raster::Image8>(raster::load_image(shell / "p.png")) == plain);
}

TEST(LeftOut, SurroundingsThatOnlyPhongShadingMirrors) {
    const Shell shell;
    const std::string mirror = " --environment room --material mirror=0.5";
    const std::string err = said(shell, "sphere --shading gouraud" + mirror);
    EXPECT_NE(err.find("scanlight: sphere: the surroundings are left out"), err.npos) << err;
    EXPECT_EQ(said(shell, "sphere" + mirror).find("left out"), std::string::npos);
    EXPECT_EQ(said(shell, "sphere --shading gouraud --environment room").find("left out"),
              std::string::npos);
}

TEST(LeftOut, TexturesOnAMeshWithoutPlacesForThem) {
    const Shell shell;
    const std::string err = said(shell, "cube --texture diffuse=checker");
    EXPECT_NE(err.find("scanlight: cube: its textures are all of one place: the mesh has no"),
              err.npos)
        << err;
    EXPECT_EQ(said(shell, "sphere --texture diffuse=checker").find("all of one place"),
              std::string::npos);
}

}  // namespace
}  // namespace scanlight::apps
