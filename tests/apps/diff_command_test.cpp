#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "raster/load_image.h"
#include "raster/save_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

using Json = nlohmann::json;

/// Three pictures: a; b, which differs in one pixel; and c, which has another size.
class Diff : public testing::Test {
protected:
    void SetUp() override {
        raster::Image8 a(4, 3, 3);
        a.pixel(1, 2)[0] = 200;
        raster::save_image(shell / "a.png", a);
        a.pixel(2, 1)[1] = 50;
        raster::save_image(shell / "b.png", a);
        raster::save_image(shell / "c.png", raster::Image8(4, 4, 3));
    }

    const Shell shell;
};

TEST_F(Diff, EndsWithZeroForTheSamePixels) {
    shell.run("cp a.png same.png");
    const Outcome outcome = shell.run("scanlight diff a.png same.png");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("different  0 of 12 pixels"), std::string::npos) << outcome.out;
}

TEST_F(Diff, EndsWithOneForOtherPixels) {
    const Outcome outcome = shell.run("scanlight diff a.png b.png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("different  1 of 12 pixels"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("0 and 50 at pixel (2, 1), channel 1"), std::string::npos)
        << outcome.out;
}

TEST_F(Diff, EndsWithTwoForAnotherSizeAndForNoPicture) {
    shell.write("text.png", "this is no picture");
    for (const auto* pair : {"a.png c.png", "a.png text.png", "a.png nosuch.png"}) {
        const Outcome outcome = shell.run(std::string("scanlight diff -o d.png ") + pair);
        EXPECT_EQ(outcome.status, 2) << pair;
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_FALSE(shell.has("d.png"));
    }
}

TEST_F(Diff, AsJsonHasTheNumbers) {
    const Outcome outcome = shell.run("scanlight diff a.png b.png --json");
    EXPECT_EQ(outcome.status, 1);
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["pixels"], 12);
    EXPECT_EQ(json["different"], 1);
    EXPECT_NEAR(json["mean"].get<double>(), 50.0 / 36.0, 1e-12);
    EXPECT_EQ(json["worst"]["x"], 2);
    EXPECT_EQ(json["worst"]["second"], 50.0);
    const Json same = Json::parse(shell.run("scanlight diff a.png a.png --json").out);
    EXPECT_EQ(same["psnr_db"], "infinite");
    EXPECT_EQ(same["worst"], nullptr);
}

TEST_F(Diff, AsJsonHasTheShortestNumbersOfItsFloats) {
    raster::ImageF floats(1, 1, 1);
    raster::save_image(shell / "a.pfm", floats);
    floats.pixel(0, 0)[0] = 0.7875f;
    raster::save_image(shell / "b.pfm", floats);
    const Outcome outcome = shell.run("scanlight diff a.pfm b.pfm --json");
    EXPECT_NE(outcome.out.find("\"second\": 0.7875\n"), std::string::npos) << outcome.out;
}

TEST_F(Diff, WritesAPictureOfTheDifference) {
    EXPECT_EQ(shell.run("scanlight diff a.png b.png -o d.png").status, 1);
    const auto image = std::get<raster::Image8>(raster::load_image(shell / "d.png"));
    EXPECT_EQ(image.width(), 4);
    EXPECT_EQ(image.height(), 3);
    EXPECT_GT(image.pixel(2, 1)[0], 60);  // red on a dim picture
    EXPECT_EQ(image.pixel(0, 0)[0], 0);
}

TEST_F(Diff, ToAPipeIsThePictureAlone) {
    const Outcome outcome = shell.run("scanlight diff a.png b.png -o -");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.out.starts_with("P6\n4 3\n255\n")) << outcome.out;
    EXPECT_NE(outcome.err.find("different  1 of 12 pixels"), std::string::npos) << outcome.err;
}

TEST_F(Diff, ReadsStandardInput) {
    EXPECT_EQ(shell.run("scanlight diff - b.png < b.png").status, 0);
    EXPECT_EQ(shell.run("scanlight diff - b.png < a.png").status, 1);
}

TEST_F(Diff, OfAnUnknownKindIsRefusedBeforeTheWork) {
    for (const auto* name : {"d.gif", "d.pgm"}) {  // differences are shown in red
        const Outcome outcome = shell.run(std::string("scanlight diff a.png b.png -o ") + name);
        EXPECT_EQ(outcome.status, 2) << name;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    }
}

}  // namespace
}  // namespace scanlight::apps
