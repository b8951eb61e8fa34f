#include "apps/demo/window/command_line.h"

#include <gtest/gtest.h>

#include "apps/scanlight/figures.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/read_scene.h"
#include "apps/scene/write_scene.h"

namespace scanlight::apps::window {
namespace {

/// What follows "scanlight render ".
std::string arguments_in(const std::string& line) {
    const std::string start = "scanlight render ";
    EXPECT_TRUE(line.starts_with(start)) << line;
    return line.substr(start.size(), line.find(" -o ") - start.size());
}

TEST(CommandLine, SaysNoMoreThanItMust) {
    EXPECT_EQ(command_line_of(parse_scene("teapot")), "scanlight render teapot -o teapot.png");
    EXPECT_EQ(command_line_of(parse_scene("torus:48,24 --shading flat --floor --zoom 2")),
              "scanlight render torus:48,24 --zoom 2 --shading flat --floor -o torus.png");
}

TEST(CommandLine, DrawsTheSamePictureForEachFigureOfTheGallery) {
    for (const Figure& figure : figures()) {
        for (const std::string& panel : figure.panels) {
            const SceneOptions options = parse_scene(panel);
            const std::string arguments = arguments_of(options);
            ASSERT_FALSE(arguments.empty()) << panel;
            EXPECT_EQ(scene_text(parse_scene(arguments), ""), scene_text(options, "")) << panel;
        }
    }
}

TEST(CommandLine, QuotesWhatAShellWouldTake) {
    const auto options = parse_scene("cube --material \"kd=0.5,0.25,1 n=7\"");
    EXPECT_EQ(arguments_of(options), "cube --material 'kd=0.5,0.25,1 n=7'");
}

TEST(CommandLine, SaysNothingOfWhatIsNotShown) {
    SceneOptions options = parse_scene("cube --illumination cook-torrance --roughness 0.3");
    options.settings.illumination = shading::Illumination::phong;
    options.settings.shadow_map.size = 64;
    EXPECT_EQ(arguments_of(options), "cube");
    options = parse_scene("cube --texture diffuse=wood");
    options.material.textures[TextureSlot::diffuse].clear();
    EXPECT_EQ(arguments_of(options), "cube");
}

TEST(CommandLine, KeepsAMetalsColourForOtherModels) {
    SceneOptions options = parse_scene("cube --illumination cook-torrance --metal gold");
    options.settings.illumination = shading::Illumination::phong;
    EXPECT_EQ(arguments_of(options), "") << "the options refuse it";
    EXPECT_NE(command_line_of(options).find("metal = \"gold\""), std::string::npos);
}

TEST(CommandLine, CarriesASceneFileWhereOptionsDoNotTellAll) {
    SceneOptions options = parse_scene("cube");
    options.objects.push_back(options.objects.front());
    options.objects.back().placement.translate = {2.0, 0.0, 0.0};
    const std::string line = command_line_of(options);
    const std::size_t begin = line.find("<<'END'\n") + 8;
    const std::string scene = line.substr(begin, line.rfind("END") - begin);
    SceneOptions read;
    read_scene(read, scene, "scene", "");
    EXPECT_EQ(arguments_in(line), "scene:-");
    EXPECT_EQ(scene_text(read, ""), scene_text(options, ""));
}

}  // namespace
}  // namespace scanlight::apps::window
