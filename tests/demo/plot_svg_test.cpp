#include "apps/demo/plot_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "apps/demo/base64.h"

namespace scanlight::demo {
namespace {

Plot plot_of(std::vector<glm::dvec2> points) {
    return {"title", {"x-axis", 0, 10}, {"y-axis", 0, 1}, {{"curve", std::move(points)}}, 5.0};
}

std::string path_in(const std::string& svg) {
    const std::size_t begin = svg.find(" d='") + 4;
    return svg.substr(begin, svg.find('\'', begin) - begin);
}

TEST(PlotSvg, KeepsWordsForWhoeverKnowsTheLanguage) {
    const std::string svg = plot_svg(plot_of({{0, 0}, {10, 1}}));
    for (const char* key : {"{{title}}", "{{x-axis}}", "{{y-axis}}", "{{curve}}"})
        EXPECT_NE(svg.find(key), std::string::npos) << key;
}

TEST(PlotSvg, RunsFromCornerToCorner) {
    EXPECT_EQ(path_in(plot_svg(plot_of({{0, 0}, {10, 1}}))), "M50.0,166.0 408.0,22.0");
}

TEST(PlotSvg, BreaksOffWhereThereIsNoNumber) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::string path =
        path_in(plot_svg(plot_of({{none, 0}, {0, 0}, {1, 0}, {2, none}, {3, 0}, {4, 0}})));
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
    EXPECT_EQ(path.find("nan"), std::string::npos);
}

TEST(PlotSvg, HoldsWhatLeavesThePlotAtItsEdge) {
    EXPECT_EQ(path_in(plot_svg(plot_of({{0, 100}, {10, -100}}))), "M50.0,19.1 408.0,168.9");
}

TEST(Base64, IsThatOfRfc4648) {
    const auto encoded = [](const std::string& text) {
        return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
    EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace scanlight::demo
