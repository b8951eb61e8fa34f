#include "apps/scene/parse.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "apps/scanlight/scene_options.h"
#include "apps/scene/usage_error.h"
#include "raster/srgb.h"

namespace scanlight::apps {
namespace {

/// Each text is refused with a message of one line that shows the text.
template <class Parse>
void expect_refused(Parse&& parse, std::initializer_list<std::string> texts) {
    for (const std::string& text : texts) {
        try {
            parse(text);
            ADD_FAILURE() << "'" << text << "' was accepted";
        } catch (const UsageError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find("expected"), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
}

TEST(ParseNumber, TakesDecimalNumbers) {
    EXPECT_EQ(parse_number("1.5", "x"), 1.5);
    EXPECT_EQ(parse_number("-2e3", "x"), -2000.0);
    EXPECT_EQ(parse_number(".5", "x"), 0.5);
    EXPECT_EQ(parse_number("1e30", "x"), 1e30);
}

TEST(ParseNumber, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_number(text, "x"); },
                   {"", " ", "abc", "1x", "1 ", " 1", "1,5", "nan", "inf", "-inf", "infinity",
                    "1e31", "1e400", "0x10", "--1", "+1"});
}

TEST(ParseSize, TakesOneTo16384EachWay) {
    const auto expect_size = [](std::string_view text, int width, int height) {
        const auto size = parse_size(text);
        EXPECT_EQ(size.width, width);
        EXPECT_EQ(size.height, height);
    };
    expect_size("640x480", 640, 480);
    expect_size("1x1", 1, 1);
    expect_size("16384x16384", 16384, 16384);
}

TEST(ParseSize, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_size(text); }, {"",
                                                                "x",
                                                                "640",
                                                                "640x",
                                                                "x480",
                                                                "0x0",
                                                                "0x5",
                                                                "5x0",
                                                                "-1x5",
                                                                "5x-1",
                                                                "16385x1",
                                                                "1x16385",
                                                                "99999999999x1",
                                                                "1x99999999999999999999",
                                                                "640X480",
                                                                "640x480x3",
                                                                "6.4x4.8",
                                                                "640 x 480",
                                                                "640x480 ",
                                                                "nanx1",
                                                                "0x10x0x10"});
}

TEST(ParseView, TakesAzimuthAndElevation) {
    const auto view = parse_view("-30.5,90");
    EXPECT_EQ(view.azimuth_deg, -30.5);
    EXPECT_EQ(view.elevation_deg, 90.0);
}

TEST(ParseView, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_view(text); },
                   {"", "30", "30,", ",20", "30,20,10", "30,90.1", "30,-91", "nan,0", "0,nan",
                    "36001,0", "a,b", "30;20"});
}

TEST(ParsePoint, TakesThreeNumbers) {
    EXPECT_EQ(parse_point("1,-2,3.5", "eye"), glm::dvec3(1.0, -2.0, 3.5));
}

TEST(ParsePoint, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_point(text, "eye"); },
                   {"", "1", "1,2", "1,2,", "1,2,3,4", "1,2,x", "1,2,nan", "1,2,1e300"});
}

TEST(ParseColor, DecodesSrgbBytes) {
    EXPECT_EQ(parse_color("#ffffff"), glm::vec3(1.0f));
    EXPECT_EQ(parse_color("#000"), glm::vec3(0.0f));
    EXPECT_EQ(parse_color("#8040C0"),
              glm::vec3(raster::linear_from_srgb(0x80), raster::linear_from_srgb(0x40),
                        raster::linear_from_srgb(0xc0)));
    EXPECT_EQ(parse_color("#f08"), parse_color("#ff0088"));
}

TEST(ParseColor, TakesLinearNumbers) {
    EXPECT_EQ(parse_color("0.25"), glm::vec3(0.25f));
    EXPECT_EQ(parse_color("2,0.5,0"), glm::vec3(2.0f, 0.5f, 0.0f));
}

TEST(ParseColor, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_color(text); },
                   {"",        "#",       "#ff", "#ffff",    "#fffff",   "#fffffff", "#ggg",
                    "#-12345", "#+12345", "red", "-1",       "1,2",      "1,2,3,4",  "1,-1,1",
                    "nan",     "inf",     "1e7", "1,1,1e39", "0.5,,0.5", "# fff"});
}

TEST(ParseLight, ComesFromTheCameraUnlessItSays) {
    const auto light = parse_light("1,2,3");
    EXPECT_EQ(light.frame, LightFrame::camera);
    EXPECT_EQ(light.place, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(light.color, glm::vec3(1.0f));
    EXPECT_EQ(light.falloff, shading::Falloff::constant);
    EXPECT_EQ(parse_light("camera:1,2,3").frame, LightFrame::camera);
    EXPECT_EQ(parse_light("world:1,2,3").frame, LightFrame::world);
    EXPECT_EQ(parse_light("point:1,2,3").frame, LightFrame::point);
}

TEST(ParseLight, TakesAColorAndAFalloffInAnyOrder) {
    for (const auto* text :
         {"point:1,2,3,#ff0000,inverse-square", "point:1,2,3,inverse-square,#ff0000"}) {
        const auto light = parse_light(text);
        EXPECT_EQ(light.color, glm::vec3(1.0f, 0.0f, 0.0f));
        EXPECT_EQ(light.falloff, shading::Falloff::inverse_square);
    }
    EXPECT_EQ(parse_light("point:1,2,3,constant").falloff, shading::Falloff::constant);
    EXPECT_EQ(parse_light("point:1,2,3,inverse").falloff, shading::Falloff::inverse);
    EXPECT_EQ(parse_light("point:1,2,3,inverse-plus-k").falloff, shading::Falloff::inverse_plus_k);
}

TEST(ParseLight, RefusesAFalloffAtInfinityAndNoDirection) {
    EXPECT_THROW(parse_light("1,2,3,inverse"), UsageError);
    EXPECT_THROW(parse_light("world:1,2,3,inverse-square"), UsageError);
    EXPECT_THROW(parse_light("0,0,0"), UsageError);
    EXPECT_NO_THROW(parse_light("point:0,0,0"));
}

TEST(ParseLight, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_light(text); },
                   {"", "1,2", "sun:1,2,3", "1,2,x", "1,2,3,", "1,2,3,red", "1,2,3,#zzz",
                    "1,2,3,square", "1,2,3,4", "nan,0,1", "point:", "point:1,2"});
}

shading::Material<float> base_material() {
    return {glm::vec3(0.1f), glm::vec3(0.2f), glm::vec3(0.3f), 7.0, {}, {}};
}

TEST(ParseMaterial, ChangesOnlyWhatItNames) {
    const auto material = with(base_material(), parse_material("ks=0.9 n=50"));
    EXPECT_EQ(material.ambient, glm::vec3(0.1f));
    EXPECT_EQ(material.diffuse, glm::vec3(0.2f));
    EXPECT_EQ(material.specular, glm::vec3(0.9f));
    EXPECT_EQ(material.exponent.value(), 50.0);
    EXPECT_EQ(with(base_material(), parse_material("")).exponent.value(), 7.0);
}

TEST(ParseMaterial, DiffuseAloneIsTheAmbientColorToo) {
    EXPECT_EQ(with(base_material(), parse_material("kd=0.5")).ambient, glm::vec3(0.5f));
    for (const auto* text : {"kd=0.5 ka=0.05", "ka=0.05  kd=0.5"}) {
        const auto material = with(base_material(), parse_material(text));
        EXPECT_EQ(material.ambient, glm::vec3(0.05f));
        EXPECT_EQ(material.diffuse, glm::vec3(0.5f));
    }
}

TEST(ParseMaterial, KnowsWhatComesThrough) {
    const auto material = with(base_material(), parse_material("kdt=0.5 kt=0.1,0.2,0.3 nt=9"));
    EXPECT_EQ(material.transmission.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(material.transmission.specular, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(material.transmission.exponent.value(), 9.0);
    EXPECT_EQ(material.diffuse, glm::vec3(0.2f));
    EXPECT_EQ(material.exponent.value(), 7.0);
}

TEST(ParseMetal, FindsItByItsName) {
    EXPECT_EQ(parse_metal("gold").name, "gold");
    expect_refused([](const auto& text) { parse_metal(text); }, {"", "Gold", "gold ", "brass"});
}

TEST(ParseMaterial, RefusesTheRest) {
    expect_refused([](const auto& text) { parse_material(text); },
                   {"kd", "kd=", "=1", "kd=red", "n=x", "n=", "n=nan", "shine=3", "kd=0.5=0.5",
                    "kd=0.5,ks=0.5", "kd = 0.5", "kd=-1", "nt=-1", "kdt=blue", "kst=1"});
}

TEST(ParseScene, IsTheCommandLineOfRender) {
    const auto options = parse_scene(
        "teapot:4 --size 20x10 --shading flat --material \"kd=#fff n=5\" --wireframe=over "
        "--light 1,0,0 --light world:0,1,0,#f00 --background none");
    EXPECT_EQ(options.input, "teapot:4");
    EXPECT_EQ(options.size.width, 20);
    EXPECT_EQ(options.settings.shading, render::Shading::flat);
    EXPECT_EQ(options.material.diffuse, glm::vec3(1.0f));
    EXPECT_EQ(options.material.exponent, 5.0);
    EXPECT_EQ(wireframe_of(options), Wireframe::over);
    ASSERT_EQ(options.lights.size(), 2u);
    EXPECT_EQ(options.lights[1].frame, LightFrame::world);
    EXPECT_FALSE(options.background);
}

TEST(ParseScene, WireframeAloneIsAll) {
    EXPECT_EQ(wireframe_of(parse_scene("cube --wireframe")), Wireframe::all);
    EXPECT_EQ(wireframe_of(parse_scene("cube")), Wireframe::none);
}

}  // namespace
}  // namespace scanlight::apps
