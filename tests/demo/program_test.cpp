// The program as people call it, and the commands that stand under its pictures.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "apps/demo/lesson.h"
#include "apps/demo/page.h"
#include "apps/demo/settings.h"
#include "raster/load_image.h"
#include "tests/apps/shell.h"
#include "tests/demo/all_screens.h"

namespace scanlight::demo {
namespace {

using apps::Outcome;
using apps::Shell;

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// The file that a panel's command leaves its picture in.
std::string output_of(const std::string& command) {
    if (command.find("--aov normal:") != std::string::npos) return "normals.png";
    return command.find("scanlight diff") != std::string::npos ? "difference.png" : "picture.png";
}

class Commands : public testing::TestWithParam<Lesson> {};

TEST_P(Commands, DrawThePicturesAboveThem) {
    const Lesson& lesson = GetParam();
    const Shell shell;
    // Scenes are named as from the root of the source.
    ASSERT_EQ(shell.run("ln -s '" SCANLIGHT_TESTS_DIR "/../apps' apps").status, 0);
    const Screen screen = lesson.draw(starting_settings(lesson), small_panel, one_thread);
    for (const Panel& panel : screen.panels) {
        const Outcome outcome = shell.run(panel.command);
        ASSERT_LT(outcome.status, 2) << panel.command << "\n" << outcome.err;
        const auto drawn = raster::load_image(shell / output_of(panel.command));
        const auto& shown = screen.walked ? screen.walked->picture : panel.picture;
        EXPECT_TRUE(std::get<raster::Image8>(drawn) == shown) << panel.command;
    }
}

INSTANTIATE_TEST_SUITE_P(Lessons, Commands, testing::ValuesIn(lessons()), lesson_test_name);

TEST(DemoProgram, ListsAllLessonsInBothLanguages) {
    const Shell shell;
    const Outcome english = shell.run("scanlight-demo --list");
    EXPECT_EQ(english.status, 0);
    EXPECT_EQ(count_of(english.out, "\n"), lessons().size());
    EXPECT_NE(english.out.find("lost-highlight"), std::string::npos);
    const Outcome chinese = shell.run("scanlight-demo --list --language zh");
    EXPECT_NE(chinese.out.find("马赫带"), std::string::npos);
}

TEST(DemoProgram, WritesALessonAsAFileOrIntoAPipe) {
    const Shell shell;
    const std::string lesson = "scanlight-demo --lesson orientation --set angle=45 --size 60x40";
    const Outcome file = shell.run(lesson + " -o a.png");
    EXPECT_EQ(file.status, 0) << file.err;
    EXPECT_NE(file.out.find("--set angle=45"), std::string::npos);
    EXPECT_NE(file.out.find("scanlight render plane:1"), std::string::npos);
    EXPECT_EQ(shell.run(lesson + " -o - > b.png").status, 0);
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
}

TEST(DemoProgram, MovedCornersAreDrawnByTheCommandUnderThePicture) {
    const Shell shell;
    const Lesson& lesson = lesson_named("edge-table");
    Settings settings = starting_settings(lesson);
    const std::string corners = "corners=0.1,1.12:-2.3,1.2:-0.1,-1.12:1.6,-0.28";
    set(settings, lesson, corners);
    const Screen screen = lesson.draw(settings, small_panel, one_thread);
    ASSERT_EQ(shell.run(screen.panels.front().command).status, 0);
    EXPECT_TRUE(std::get<raster::Image8>(raster::load_image(shell / "picture.png")) ==
                screen.walked->picture);
    const std::string line = "scanlight-demo --lesson edge-table --set " + corners;
    const Outcome outcome = shell.run(line + " -s 120x90 -o lesson.png");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(std::get<raster::Image8>(raster::load_image(shell / "lesson.png")) ==
                picture_of(screen));
    EXPECT_NE(outcome.out.find("--set " + corners), std::string::npos) << outcome.out;
}

TEST(DemoProgram, ASmallPolygonIsShownAtItsLastStep) {
    const Shell shell;
    const std::string line =
        "scanlight-demo --lesson edge-table -s 48x32 --set corners=0,0:0,0.2:0.2,0";
    const Outcome outcome = shell.run(line + " -o a.png");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(shell.run(line + " --set step=61").status, 2);
}

TEST(DemoProgram, AFrameIsAStopOfTheFirstControl) {
    const Shell shell;
    EXPECT_EQ(
        shell.run("scanlight-demo --lesson lost-highlight --frame 3 -s 40x30 -o a.png").status, 0);
    EXPECT_EQ(
        shell.run("scanlight-demo --lesson lost-highlight --set level=3 -s 40x30 -o b.png").status,
        0);
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
}

TEST(DemoProgram, RefusesWhatItCannotDo) {
    const Shell shell;
    for (const char* arguments :
         {"--lesson nothing", "--lesson mach-bands --set cut=7", "--lesson mach-bands --set x=1",
          "--lesson mach-bands --frame 99", "--lesson edge-table --set step=400",
          "--lesson edge-table --frame 400", "--lesson lost-highlight --set level=2.5",
          "--lesson mach-bands --language de", "--frame 1", "--nonsense",
          "--lesson edge-table --set corners=0,0:1,1", "--lesson edge-table --set corners=x",
          "--lesson edge-table --set corners=0,0:1,0.04:2,0.08",
          "--lesson edge-table --set corners=0,0:0.05,0.04:0,0.04",
          "--lesson mach-bands -o picture.xyz", "--lesson mach-bands --size 0x3",
          "--export /dev/null/course"}) {
        const Outcome outcome = shell.run(std::string("scanlight-demo ") + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(outcome.err.starts_with("scanlight-demo: ")) << outcome.err;
        EXPECT_EQ(count_of(outcome.err, "\n"), 1u) << outcome.err;
    }
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(DemoProgram, HelpHasExamples) {
    const Shell shell;
    const Outcome help = shell.run("scanlight-demo --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("scanlight-demo --export course"), std::string::npos);
    EXPECT_EQ(shell.run("scanlight-demo --version").out, "scanlight-demo " SCANLIGHT_VERSION "\n");
}

TEST(DemoProgram, TheWindowHasHelpToo) {
    const Shell shell;
    const Outcome help = shell.run("scanlight-demo --window --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find("--snapshot"), std::string::npos);
}

TEST(DemoProgram, TheWindowSaysWhatIsWrongAsTheCourseDoes) {
    const Shell shell;
    const std::string told =
        "scanlight-demo: The following argument was not expected: --nonsense; "
        "see scanlight-demo --help\n";
    for (const char* arguments : {"--nonsense --list", "--nonsense --window"}) {
        const Outcome outcome = shell.run(std::string("scanlight-demo ") + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.err, told) << arguments;
    }
}

TEST(DemoProgram, AFullDiskIsAnError) {
    const Shell shell;
    for (const char* arguments : {"--help", "--window --help"}) {
        const Outcome outcome =
            shell.run(std::string("scanlight-demo ") + arguments + " >/dev/full");
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.err, "scanlight-demo: standard output: cannot be written\n");
    }
}

TEST(DemoProgram, ALessonBringsTheFilesOfItsCommands) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight-demo --lesson transparency --size 24x18");
    EXPECT_NE(outcome.out.find("# scanlight render apps/demo/scenes/panes.toml\n"),
              std::string::npos);
}

TEST(DemoProgram, SaysWhichStepsAPolygonHas) {
    const Shell shell;
    const std::string lesson = "scanlight-demo --lesson edge-table --set step=";
    const std::string err = shell.run(lesson + "400").err;
    const std::string last = err.substr(err.rfind(' ') + 1);
    EXPECT_EQ(shell.run(lesson + last).status, 0) << err;
}

// ---- the page

std::vector<Lesson> few_lessons() {
    return {lesson_named("edge-table"), lesson_named("transparency")};
}

std::string drawn_page() {
    return course_page(few_lessons(), {Language::chinese, {24, 18}, one_thread},
                       [](const std::string&) {});
}

const std::string& small_page() {
    static const std::string page = drawn_page();
    return page;
}

TEST(Page, HoldsAllThatItNeeds) {
    const std::string& page = small_page();
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>\n<html lang=\"zh\">"));
    for (const Lesson& lesson : few_lessons())
        EXPECT_NE(page.find("\"name\":\"" + lesson.name + "\""), std::string::npos) << lesson.name;
    EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
    EXPECT_NE(page.find("class Stepper"), std::string::npos);
    EXPECT_EQ(page.find("{{style}}"), std::string::npos);
}

TEST(Page, SaysWhatTheWindowAloneCanSet) {
    EXPECT_NE(small_page().find("\"pointed\":[\"corners\"]"), std::string::npos);
    EXPECT_NE(small_page().find("\"pointed\":[]"), std::string::npos);
    EXPECT_EQ(small_page().find("\"name\":\"corners\""), std::string::npos);
}

TEST(Page, NamesNoAddress) {
    const std::string& page = small_page();
    // The namespace of SVG is a name, which nobody fetches.
    EXPECT_EQ(count_of(page, "http"), count_of(page, "http://www.w3.org/2000/svg"));
    EXPECT_EQ(page.find("src=\""), std::string::npos);
    EXPECT_EQ(page.find("@import"), std::string::npos);
}

TEST(Page, DataCannotEndItsScript) {
    const std::string& page = small_page();
    const std::size_t begin = page.find("id=\"data\">");
    const std::size_t end = page.find("</script>", begin);
    EXPECT_EQ(page.substr(begin + 10, end - begin - 10).find('<'), std::string::npos);
    EXPECT_GT(end - begin, 50000u);
}

TEST(Page, IsTheSameEachTime) {
    EXPECT_TRUE(drawn_page() == small_page());
}

}  // namespace
}  // namespace scanlight::demo
