#include <gtest/gtest.h>

#include <set>
#include <string>

#include "apps/scanlight/frame_pattern.h"
#include "apps/scene/camera_path.h"
#include "apps/scene/read_scene.h"
#include "apps/scene/usage_error.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

TEST(FramePattern, NumbersFiles) {
    EXPECT_EQ(FramePattern("a/%04d.png").name(7), "a/0007.png");
    EXPECT_EQ(FramePattern("%d.png").name(123), "123.png");
    EXPECT_EQ(FramePattern("x%02d").name(1234), "x1234");
}

TEST(FramePattern, RefusesTheRest) {
    for (const std::string text : {"a.png", "%s.png", "%04d%d.png", "%4d.png", "%0d.png", "%-4d",
                                   "%", "100%", "%%04d.png", "%012d.png", "%04x.png", "%n", ""})
        EXPECT_THROW(FramePattern{text}, UsageError) << text;
}

/// Runs a line that must succeed.
Outcome run(const Shell& shell, const std::string& line) {
    Outcome outcome = shell.run(line);
    EXPECT_EQ(outcome.status, 0) << line << '\n' << outcome.err;
    return outcome;
}

TEST(Turntable, WritesNumberedFramesIntoANewFolder) {
    const Shell shell;
    run(shell, "scanlight turntable shape:cone:7 -o a/b/%03d.png --frames 5 -s 24x16");
    std::set<std::string> pictures;
    for (const std::string number : {"000", "001", "002", "003", "004"})
        pictures.insert(shell.read("a/b/" + number + ".png"));
    EXPECT_EQ(pictures.size(), 5u);
    EXPECT_FALSE(shell.has("a/b/005.png"));
}

TEST(Turntable, OfAFullTurnEndsWhereItBegan) {
    const Shell shell;
    run(shell, "scanlight turntable teapot:2 -o %d.png --frames 2 --orbit-deg 720 -s 24x16");
    EXPECT_EQ(shell.read("0.png"), shell.read("1.png"));
}

TEST(Turntable, IsTheSameByAnyMeans) {
    const Shell shell;
    const std::string line = "scanlight turntable teapot:2 -q --frames 3 -s 40x30 --samples 4 ";
    run(shell, line + "-o a.gif");
    run(shell, line + "-o b.gif --threads 3");
    run(shell, line + "-o c.gif --path textbook");
    EXPECT_EQ(shell.read("a.gif"), shell.read("b.gif"));
    EXPECT_EQ(shell.read("a.gif"), shell.read("c.gif"));
    EXPECT_TRUE(shell.read("a.gif").starts_with("GIF89a"));
}

TEST(Turntable, StreamsPicturesToStandardOutput) {
    const Shell shell;
    const std::string line = "scanlight turntable cube -o - --frames 3 -s 8x4";
    const std::string stream = run(shell, line).out;
    const std::string header = "P6\n8 4\n255\n";
    EXPECT_EQ(stream.size(), 3 * (header.size() + 8 * 4 * 3));
    EXPECT_TRUE(stream.starts_with(header));
    EXPECT_TRUE(run(shell, line + " --format png").out.starts_with("\x89PNG"));
    EXPECT_TRUE(run(shell, line + " --format gif").out.starts_with("GIF89a"));
}

TEST(Turntable, RefusesWhatCannotBe) {
    const Shell shell;
    shell.write("file", "");
    shell.write("k.toml",
                "[[object]]\nshape = \"cube\"\n[[camera.key]]\nat = 0.5\nview = [0, 0]\n"
                "[[camera.key]]\nat = 0.5\nview = [9, 0]\n");
    const std::pair<std::string, std::string> cases[] = {
        {"cube -o a.png", "output 'a.png': expected one %d or %0Nd"},
        {"cube -o %s.png", "output '%s.png': expected one %d or %0Nd"},
        {"cube -o %d.gig", "%d.gig"},
        {"cube -o a.gif --background none", "a.gif: this format holds no alpha"},
        {"cube -o file/%d.png", "file: cannot be made a folder"},
        {"cube -o a.gif --frames 0", "--frames"},
        {"cube -o a.gif --orbit-deg nan", "nan"},
        {"cube -o a.gif --eye 1,2,3 --elevation-deg 5", "--elevation-deg with an eye"},
        {"cube -o a.gif --samples 16 --size 9000x10", "expected at most 4096 pixels each way"},
        {"cube", "--output"},
        {"k.toml -o a.gif", "k.toml:7:6: [[camera.key]] is not later than the one before"},
    };
    for (const auto& [arguments, message] : cases) {
        const Outcome outcome = shell.run("scanlight turntable " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(shell.file_count(), 2u);
}

TEST(CameraPath, GoesFromKeyToKey) {
    SceneOptions options;
    read_scene(options,
               "[[camera.key]]\nat = 0\neye = [0, 0, 5]\n[[camera.key]]\nat = 1\neye = [4, 0, 5]\n"
               "zoom = 2\n[[object]]\nshape = \"cube\"\ntranslate = [1, 2, 3]\n",
               "scene.toml", "");
    const Models models = load_models(options);
    const CameraPath path(models, options, {});
    EXPECT_EQ(path.at(0.0).eye, glm::dvec3(0.0, 0.0, 5.0));
    EXPECT_EQ(path.at(1.0).eye, glm::dvec3(4.0, 0.0, 5.0));
    EXPECT_EQ(path.at(0.5).eye, glm::dvec3(2.0, 0.0, 5.0));
    EXPECT_EQ(path.at(0.5).zoom, 1.5);
    EXPECT_EQ(path.at(0.3).target, glm::dvec3(1.0, 2.0, 3.0));
}

TEST(CameraPath, OfAnOrbitStaysAtOneDistance) {
    SceneOptions options;
    set_input(options, "shape:teapot:2");
    const Models models = load_models(options);
    const CameraPath path(models, options, {360.0, 10.0});
    const auto distance = [&](double time) {
        const SceneOptions moment = path.at(time);
        const glm::dvec3 arm = *moment.eye - *moment.target;
        return arm.x * arm.x + arm.y * arm.y + arm.z * arm.z;
    };
    for (const double time : {0.1, 0.4, 0.7})
        EXPECT_NEAR(distance(time), distance(0.0), 1e-9);
}

}  // namespace
}  // namespace scanlight::apps
