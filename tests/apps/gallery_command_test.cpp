#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "apps/scanlight/figures.h"
#include "raster/load_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

TEST(Figures, HaveNamesThatFilesMayHave) {
    std::set<std::string> names;
    for (const Figure& figure : figures()) {
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name << " twice";
        EXPECT_EQ(figure.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
                  std::string::npos)
            << figure.name;
        EXPECT_FALSE(figure.caption.empty()) << figure.name;
        EXPECT_FALSE(figure.panels.empty()) << figure.name;
    }
    EXPECT_GE(names.size(), 24u);
}

TEST(Gallery, WritesEachFigureAndAPageThatNamesIt) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight gallery new/pictures --panel 32x24");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "") << "no progress line without a terminal";
    const std::string page = shell.read("new/pictures/index.html");
    for (const Figure& figure : figures()) {
        const auto image = std::get<raster::Image8>(
            raster::load_image(shell / ("new/pictures/" + figure.name + ".png")));
        EXPECT_EQ(image.width(), 32 * static_cast<int>(figure.panels.size())) << figure.name;
        EXPECT_EQ(image.height(), 24);
        EXPECT_NE(page.find("src=\"" + figure.name + ".png\""), std::string::npos) << figure.name;
    }
    EXPECT_EQ(page.find("<pre></pre>"), std::string::npos);
}

TEST(Gallery, OfOneNameWritesOnePicture) {
    const Shell shell;
    EXPECT_EQ(shell.run("scanlight gallery . --only shading --panel 16x12").status, 0);
    EXPECT_TRUE(shell.has("shading.png"));
    EXPECT_EQ(shell.file_count(), 1u);
}

TEST(Gallery, PanelsAreWhatTheirCommandsDraw) {
    const Shell shell;
    const Figure& figure = figures().front();
    const auto sheet = draw_figure(figure, {40, 30});
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        ASSERT_EQ(shell.run("scanlight render -q -o a.png -s 40x30 " + figure.panels[i]).status, 0);
        const auto panel = std::get<raster::Image8>(raster::load_image(shell / "a.png"));
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const auto expected = panel.pixel(x, y);
                const auto drawn = sheet.pixel(static_cast<int>(i) * 40 + x, y);
                ASSERT_TRUE(std::equal(expected.begin(), expected.end(), drawn.begin()))
                    << figure.panels[i] << ": " << x << ' ' << y;
            }
        }
    }
}

TEST(Gallery, IntoAFileIsRefused) {
    const Shell shell;
    shell.write("file", "");
    const Outcome outcome = shell.run("scanlight gallery file --panel 8x8");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
}

}  // namespace
}  // namespace scanlight::apps
