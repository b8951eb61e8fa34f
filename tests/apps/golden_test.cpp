// Every figure of the gallery, small, against the picture that a person once looked at and
// accepted.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

#include "apps/scanlight/figures.h"
#include "raster/compare.h"
#include "raster/image_error.h"
#include "raster/load_image.h"
#include "raster/save_image.h"

namespace scanlight::apps {
namespace {

namespace fs = std::filesystem;

constexpr raster::Viewport panel_size{96, 72};

fs::path golden_folder() {
    return fs::path(SCANLIGHT_TESTS_DIR) / "goldens";
}

fs::path golden_path(const std::string& name) {
    return golden_folder() / (name + ".png");
}

fs::path failure_path(const std::string& name, const std::string& what) {
    return fs::path(SCANLIGHT_BUILD_DIR) / "golden-failures" / (name + "-" + what + ".png");
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool is_accepted(const std::string& name) {
    const std::string accepted = environment("SCANLIGHT_ACCEPT");
    return accepted == "all" || accepted == name;
}

std::string how_to_accept(const std::string& name) {
    return "If the new picture is right, accept it: ./dev golden " + name;
}

void save_failure(const std::string& name, const std::string& what, const raster::AnyImage& image) {
    const fs::path path = failure_path(name, what);
    fs::create_directories(path.parent_path());
    raster::save_image(path.string(), image);
}

std::string told(const raster::Difference& difference) {
    const auto& worst = *difference.worst;
    return std::to_string(difference.different_pixels) + " of " +
           std::to_string(difference.pixels) + " pixels differ; the worst is (" +
           std::to_string(worst.x) + ", " + std::to_string(worst.y) + "), channel " +
           std::to_string(worst.channel) + ": " + std::to_string(worst.first) + " expected, " +
           std::to_string(worst.second) + " drawn";
}

testing::AssertionResult accepted(const std::string& name, const raster::Image8& actual) {
    if (!environment("CI").empty()) {
        return testing::AssertionFailure() << "goldens are accepted by people, not by CI";
    }
    fs::create_directories(golden_folder());
    raster::save_image(golden_path(name).string(), actual);
    std::cout << "accepted: " << golden_path(name).string() << '\n';
    return testing::AssertionSuccess();
}

testing::AssertionResult incomparable(const std::string& name, const raster::Image8& actual,
                                      const std::string& reason) {
    save_failure(name, "actual", actual);
    return testing::AssertionFailure()
           << reason << "; the picture drawn is " << failure_path(name, "actual").string() << '\n'
           << how_to_accept(name);
}

/// Pixel for pixel. A difference leaves three pictures to look at, under the name of `report`.
testing::AssertionResult same_pixels(const std::string& name, const raster::AnyImage& expected,
                                     const raster::Image8& actual, const std::string& report) {
    const raster::Difference difference = raster::compare(expected, actual);
    if (difference.different_pixels == 0) return testing::AssertionSuccess();
    save_failure(report, "expected", expected);
    save_failure(report, "actual", actual);
    save_failure(report, "difference", raster::difference_image(expected, actual));
    return testing::AssertionFailure()
           << told(difference) << "\nLook at " << failure_path(report, "expected").string()
           << "\n        " << failure_path(report, "actual").string() << "\n        "
           << failure_path(report, "difference").string() << '\n'
           << how_to_accept(name);
}

testing::AssertionResult matches_golden(const std::string& name, const raster::Image8& actual) {
    if (is_accepted(name)) return accepted(name, actual);
    if (!fs::exists(golden_path(name))) {
        return incomparable(name, actual, golden_path(name).string() + " is missing");
    }
    try {
        return same_pixels(name, raster::load_image(golden_path(name).string()), actual, name);
    } catch (const raster::ImageError& error) {  // damaged, or of another size
        return incomparable(name, actual, error.what());
    }
}

class Golden : public testing::TestWithParam<Figure> {};

TEST_P(Golden, Matches) {
    EXPECT_TRUE(matches_golden(GetParam().name, draw_figure(GetParam(), panel_size)));
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

INSTANTIATE_TEST_SUITE_P(Figures, Golden, testing::ValuesIn(figures()), test_name);

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
    for (const auto& all : {figures(), file_figures()}) {
        for (const Figure& figure : all)
            names.insert(figure.name);
    }
    for (const auto& entry : fs::directory_iterator(golden_folder())) {
        EXPECT_TRUE(names.contains(entry.path().stem().string())) << entry.path();
    }
}

TEST(Goldens, AcceptedOneIsAFigure) {
    const std::string name = environment("SCANLIGHT_ACCEPT");
    const auto has_name = [&name](const Figure& figure) { return figure.name == name; };
    EXPECT_TRUE(name.empty() || name == "all" || std::ranges::any_of(figures(), has_name))
        << "no figure is named '" << name << "'";
}

TEST(Goldens, OnePixelIsEnoughToFail) {
    const Figure& figure = figures().front();
    const raster::Image8 expected = draw_figure(figure, panel_size);
    raster::Image8 drawn = expected;
    drawn.pixel(17, 5)[1] ^= 1;
    const std::string report = "proof-that-it-fails";
    const auto result = same_pixels(figure.name, expected, drawn, report);
    ASSERT_FALSE(result);
    const std::string message = result.message();
    EXPECT_NE(message.find("1 of " + std::to_string(drawn.width() * drawn.height()) + " pixels"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("(17, 5), channel 1"), std::string::npos) << message;
    EXPECT_NE(message.find("./dev golden " + figure.name), std::string::npos) << message;
    for (const char* what : {"expected", "actual", "difference"}) {
        EXPECT_TRUE(fs::remove(failure_path(report, what))) << what;
    }
}

}  // namespace

// What a failing parameterized test prints.
void PrintTo(const Figure& figure, std::ostream* out) {
    *out << figure.name;
}

}  // namespace scanlight::apps
