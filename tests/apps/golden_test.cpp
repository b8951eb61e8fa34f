// Every figure of the gallery, small, against the picture that a person once looked at and
// accepted.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "apps/scanlight/figures.h"
#include "tests/golden/golden.h"

namespace scanlight::apps {
namespace {

namespace fs = std::filesystem;

constexpr raster::Viewport panel_size{96, 72};

/// The example scenes of the documentation, which are drawn as figures are.
std::vector<Figure> scene_figures() {
    std::vector<Figure> scenes;
    for (const auto& entry : fs::directory_iterator(SCANLIGHT_TESTS_DIR "/../docs/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        const std::string quoted_path = '"' + entry.path().string() + '"';
        scenes.push_back({"scene-" + entry.path().stem().string(), "", {quoted_path}});
    }
    std::ranges::sort(scenes, {}, &Figure::name);
    return scenes;
}

const std::vector<Figure>& golden_figures() {
    static const std::vector<Figure> all = [] {
        std::vector<Figure> both = figures();
        std::ranges::copy(scene_figures(), std::back_inserter(both));
        return both;
    }();
    return all;
}

class Golden : public testing::TestWithParam<Figure> {};

TEST_P(Golden, Matches) {
    EXPECT_TRUE(golden::matches(GetParam().name, draw_figure(GetParam(), panel_size)));
}

TEST_P(Golden, IsTheSameByTheTextbooksWalk) {
    EXPECT_TRUE(draw_figure(GetParam(), panel_size) ==
                draw_figure(GetParam(), panel_size, {DrawPath::textbook, {}}));
}

std::string test_name(const testing::TestParamInfo<Figure>& info) {
    std::string name = info.param.name;
    for (char& c : name)
        c = c == '-' ? '_' : c;
    return name;
}

INSTANTIATE_TEST_SUITE_P(Figures, Golden, testing::ValuesIn(golden_figures()), test_name);

/// Of files in tests/data, which no page of the gallery can name.
std::vector<Figure> file_figures() {
    const std::string crate = "\"" SCANLIGHT_TESTS_DIR "/data/crate.obj\" --view 35,30";
    return {{"own-textures",
             "A box whose materials bring textures: planks and stones with their relief, and a "
             "label laid once. Beside it the same without them.",
             {crate, crate + " --no-textures"}}};
}

INSTANTIATE_TEST_SUITE_P(Files, Golden, testing::ValuesIn(file_figures()), test_name);

TEST(Goldens, EachBelongsToAFigure) {
    std::set<std::string> names;
    for (const auto& all : {golden_figures(), file_figures()}) {
        for (const Figure& figure : all)
            names.insert(figure.name);
    }
    for (const auto& entry : fs::directory_iterator(golden::folder())) {
        if (entry.is_directory()) continue;  // of other tests
        EXPECT_TRUE(names.contains(entry.path().stem().string())) << entry.path();
    }
}

TEST(Goldens, AcceptedOneIsAFigure) {
    const std::string name = golden::accepted_name();
    if (name.find('/') != std::string::npos) return;  // of other tests
    const auto has_name = [&name](const Figure& figure) { return figure.name == name; };
    EXPECT_TRUE(name.empty() || name == "all" || std::ranges::any_of(golden_figures(), has_name))
        << "no figure is named '" << name << "'";
}

TEST(Goldens, OnePixelIsEnoughToFail) {
    const Figure& figure = figures().front();
    const raster::Image8 expected = draw_figure(figure, panel_size);
    raster::Image8 drawn = expected;
    drawn.pixel(17, 5)[1] ^= 1;
    const std::string report = "proof-that-it-fails";
    const auto result = golden::same_pixels(figure.name, expected, drawn, report);
    ASSERT_FALSE(result);
    const std::string message = result.message();
    EXPECT_NE(message.find("1 of " + std::to_string(drawn.width() * drawn.height()) + " pixels"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("(17, 5), channel 1"), std::string::npos) << message;
    EXPECT_NE(message.find("./dev golden " + figure.name), std::string::npos) << message;
    for (const char* what : {"expected", "actual", "difference"}) {
        EXPECT_TRUE(fs::remove(golden::failure_path(report, what))) << what;
    }
}

}  // namespace

// What a failing parameterized test prints.
void PrintTo(const Figure& figure, std::ostream* out) {
    *out << figure.name;
}

}  // namespace scanlight::apps
