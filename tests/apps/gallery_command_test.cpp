#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err,
              "new/pictures/index.html: " + std::to_string(figures().size()) + " figures written\n")
        << "no progress line without a terminal";
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
    const Outcome outcome = shell.run("scanlight gallery . --only shading --panel 16x12");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "./shading.png: 1 figure written\n");
    EXPECT_TRUE(shell.has("shading.png"));
    EXPECT_EQ(shell.file_count(), 1u);
}

/// The commands that the page shows below a figure.
std::vector<std::string> commands_below(const std::string& page, const std::string& figure) {
    const std::size_t begin = page.find("<pre>", page.find("id=\"" + figure + "\"")) + 5;
    std::istringstream lines(page.substr(begin, page.find("</pre>", begin) - begin));
    std::vector<std::string> commands;
    for (std::string line; std::getline(lines, line);)
        commands.push_back(line);
    return commands;
}

void expect_part(const raster::Image8& sheet, int x0, const raster::Image8& panel) {
    for (int y = 0; y < panel.height(); ++y) {
        for (int x = 0; x < panel.width(); ++x) {
            ASSERT_TRUE(std::ranges::equal(panel.pixel(x, y), sheet.pixel(x0 + x, y)))
                << x << ' ' << y;
        }
    }
}

TEST(Gallery, FiguresAreWhatThePagesCommandsDraw) {
    const Shell shell;
    ASSERT_EQ(shell.run("scanlight gallery . --panel 40x30").status, 0);
    const std::string page = shell.read("index.html");
    for (const Figure& figure : figures()) {
        const auto sheet =
            std::get<raster::Image8>(raster::load_image(shell / (figure.name + ".png")));
        const auto commands = commands_below(page, figure.name);
        ASSERT_EQ(commands.size(), figure.panels.size()) << figure.name;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            SCOPED_TRACE(commands[i]);
            ASSERT_EQ(shell.run(commands[i] + " -o panel.png").status, 0);
            const auto panel = std::get<raster::Image8>(raster::load_image(shell / "panel.png"));
            ASSERT_EQ(panel.width(), 40);
            expect_part(sheet, static_cast<int>(i) * 40, panel);
        }
    }
}

TEST(Gallery, OfAnUnknownNameListsTheKnownOnes) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight gallery new --only nosuchfigure");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    for (const Figure& figure : figures())
        EXPECT_NE(outcome.err.find(" " + figure.name), std::string::npos) << figure.name;
    EXPECT_FALSE(shell.has("new"));
}

TEST(Gallery, IntoAFileIsRefused) {
    const Shell shell;
    shell.write("file", "");
    for (const auto* folder : {"file", "file/below"}) {
        const Outcome outcome = shell.run(std::string("scanlight gallery --panel 8x8 ") + folder);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.err, "scanlight: " + std::string(folder) +
                                   ": cannot be made a folder: Not a directory\n");
    }
}

}  // namespace
}  // namespace scanlight::apps
