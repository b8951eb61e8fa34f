#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "raster/image.h"
#include "raster/save_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

using Json = nlohmann::json;

raster::Image8 dot_at(int x) {
    raster::Image8 image(6, 4, 3);
    image.pixel(x, 1)[0] = 200;
    image.pixel(x, 2)[1] = 100;
    return image;
}

/// Solutions of two exercises, and two who handed in.
class Grade : public testing::Test {
protected:
    void SetUp() override {
        shell.run("mkdir solutions ada bob");
        for (const auto* folder : {"solutions", "ada"}) {
            raster::save_image(shell / (std::string(folder) + "/one.png"), dot_at(2));
            raster::save_image(shell / (std::string(folder) + "/two.png"), dot_at(4));
        }
        raster::save_image(shell / "bob/one.png", dot_at(1));
    }

    const Shell shell;
};

TEST_F(Grade, GivesAllPointsForTheRightPicture) {
    const Outcome outcome = shell.run("scanlight grade solutions/one.png ada/one.png");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("10.00  pass"), std::string::npos) << outcome.out;
}

TEST_F(Grade, SaysWhatIsWrongAndGoesOn) {
    shell.write("ada/two.png", "no picture");
    const Outcome outcome = shell.run("scanlight grade solutions ada bob --json --points 4");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    const Json json = Json::parse(outcome.out);
    const Json& ada = json["candidates"][0];
    EXPECT_EQ(ada["points"], 4.0);
    EXPECT_EQ(ada["of"], 8.0);
    EXPECT_EQ(ada["passes"], false);
    EXPECT_NE(ada["pictures"][1]["remark"].get<std::string>().find("not a PNG"), std::string::npos);
    const Json& bob = json["candidates"][1];
    EXPECT_EQ(bob["pictures"][0]["remark"], "all of it lies one pixel too far left");
    EXPECT_EQ(bob["pictures"][1]["remark"], "missing");
    EXPECT_EQ(bob["points"], 0.0);
}

TEST_F(Grade, PassesByTheShareThatIsAskedFor) {
    shell.run("rm ada/two.png");
    EXPECT_EQ(shell.run("scanlight grade solutions ada --pass 50").status, 0);
    EXPECT_EQ(shell.run("scanlight grade solutions ada --pass 50.1").status, 1);
}

TEST_F(Grade, TellsSizesApartAndNeverFails) {
    raster::save_image(shell / "bob/two.png", raster::Image8(3, 3, 1));
    const Outcome outcome = shell.run("scanlight grade solutions bob");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.out.find("the sizes differ: 6 x 4 and 3 x 3"), std::string::npos)
        << outcome.out;
}

TEST_F(Grade, PutsDifferencesIntoAFolder) {
    shell.run("scanlight grade solutions ada bob --differences wrong/deep");
    EXPECT_TRUE(shell.has("wrong/deep/bob-one.png"));
    EXPECT_FALSE(shell.has("wrong/deep/ada-one.png"));
    EXPECT_FALSE(shell.has("wrong/deep/bob-two.png"));
}

TEST_F(Grade, RefusesReferencesThatAreNone) {
    shell.run("mkdir empty");
    for (const auto* line : {"nosuch.png ada/one.png", "empty ada", "solutions ada/one.png",
                             "solutions/one.png ada/one.png --points 0"}) {
        const Outcome outcome = shell.run(std::string("scanlight grade ") + line);
        EXPECT_EQ(outcome.status, 2) << line;
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

}  // namespace
}  // namespace scanlight::apps
