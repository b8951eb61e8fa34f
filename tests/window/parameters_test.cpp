#include "apps/demo/window/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "apps/scanlight/scene_options.h"
#include "apps/scene/parse.h"
#include "apps/scene/write_scene.h"

namespace scanlight::apps::window {
namespace {

const shading::Material<float> material{glm::vec3(0.1f), glm::vec3(0.2f), glm::vec3(0.3f), 40.0};

const Parameter& parameter(const std::string& name) {
    static const std::vector<Parameter> all = parameters();
    return *std::ranges::find(all, name, &Parameter::name);
}

TEST(Parameters, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Parameter& p : parameters())
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
}

TEST(Parameters, EachWordAndEachEndOfASliderIsAValue) {
    SceneOptions options = parse_scene("teapot --texture diffuse=wood --texture bump=waves");
    options.environment.image = "room";
    for (const Parameter& p : parameters()) {
        for (const std::string& word : p.words) {
            const auto set = with_value(options, p, text_value(word));
            EXPECT_EQ(text_of(*shown_value(p, set, material)), word) << p.name;
        }
        if (p.control != Control::slider) continue;
        for (const double end : {p.low, p.high}) {
            const auto set = with_value(options, p, number_value(end));
            EXPECT_NEAR(number_of(*shown_value(p, set, material)).value(), end, 1e-6) << p.name;
        }
    }
}

TEST(Parameters, ShowTheMaterialsOwnValuesUntilOthersAreSaid) {
    SceneOptions options = parse_scene("teapot");
    EXPECT_EQ(color_of(*shown_value(parameter("diffuse"), options, material)), glm::vec3(0.2f));
    options = with_value(options, parameter("diffuse"), color_value(glm::vec3(0.5f)));
    EXPECT_EQ(color_of(*shown_value(parameter("diffuse"), options, material)), glm::vec3(0.5f));
    EXPECT_EQ(options.material.diffuse, glm::vec3(0.5f));
}

TEST(Parameters, TransparencyIsWhatOpacityLeaves) {
    const auto options =
        with_value(parse_scene("teapot"), parameter("transparency"), number_value(0.25));
    EXPECT_EQ(options.material.opacity, 0.75f);
}

TEST(Parameters, OnlyThoseOfTheModelApply) {
    const auto phong = parse_scene("teapot");
    const auto facets = parse_scene("teapot --illumination cook-torrance");
    EXPECT_TRUE(applies(parameter("exponent"), phong));
    EXPECT_FALSE(applies(parameter("exponent"), facets));
    EXPECT_FALSE(applies(parameter("roughness"), phong));
    EXPECT_TRUE(applies(parameter("roughness"), facets));
}

TEST(Parameters, WhatIsNoValueChangesNothing) {
    const SceneOptions options = parse_scene("teapot");
    const auto same = with_value(options, parameter("shading"), text_value("gouraut"));
    EXPECT_EQ(scene_text(same, ""), scene_text(options, ""));
}

TEST(Parameters, ALightThatWasNotSaidCanBeColoured) {
    const auto of_light = light_parameters(0);
    const auto options = with_value(parse_scene("teapot"), of_light.at(0),
                                    color_value(glm::vec3(1.0f, 0.5f, 0.25f)));
    ASSERT_EQ(options.lights.size(), 1u);
    EXPECT_EQ(options.lights[0].color, parse_color("#ffbc89")) << "which a command line can say";
}

TEST(Parameters, ATextureCanBePutOnAndTakenOff) {
    const SceneOptions options = parse_scene("teapot");
    const Parameter& p = parameter("diffuse texture");
    const auto wood = with_value(options, p, text_value("wood"));
    EXPECT_EQ(scene_text(wood, ""), scene_text(parse_scene("teapot --texture diffuse=wood"), ""));
    const auto none = with_value(wood, p, text_value("none"));
    EXPECT_EQ(scene_text(none, ""), scene_text(options, ""));
}

TEST(Knobs, AreOfKeysThatThereAre) {
    EXPECT_THROW(knob("render", "colour"), std::invalid_argument);
    EXPECT_THROW(knob("rendr", "zoom"), std::invalid_argument);
}

}  // namespace
}  // namespace scanlight::apps::window
