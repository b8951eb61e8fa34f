// What the program says of itself and of mistakes, and what it ends with.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "render/renderer.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

const std::vector<std::string> commands{"render", "info", "diff", "steps", "gallery"};

// ---- help and version

TEST(Help, OfTheProgramNamesEveryCommand) {
    const Shell shell;
    for (const auto* line : {"scanlight --help", "scanlight -h", "scanlight"}) {
        const Outcome outcome = shell.run(line);
        EXPECT_EQ(outcome.status, 0) << line;
        EXPECT_EQ(outcome.err, "");
        for (const auto& command : commands)
            EXPECT_NE(outcome.out.find("\n  " + command), std::string::npos) << command;
        EXPECT_NE(outcome.out.find("Examples:"), std::string::npos);
    }
}

TEST(Help, OfEachCommandHasExamples) {
    const Shell shell;
    for (const auto& command : commands) {
        const Outcome outcome = shell.run("scanlight " + command + " --help");
        EXPECT_EQ(outcome.status, 0) << command;
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("scanlight " + command), std::string::npos) << command;
        EXPECT_NE(outcome.out.find("Examples:"), std::string::npos) << command;
    }
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(Version, IsOneLineFromEachCommand) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight --version");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(outcome.out.starts_with("scanlight ")) << outcome.out;
    EXPECT_EQ(outcome.out.find('\n'), outcome.out.size() - 1);
    for (const auto& command : commands) {
        const Outcome same = shell.run("scanlight " + command + " --version");
        EXPECT_EQ(same.status, 0) << command;
        EXPECT_EQ(same.out, outcome.out) << command;
    }
}

// ---- mistakes

/// One line that begins with the program's name, exit status 2, and no file that was not there.
void expect_refused(const Shell& shell, const std::string& line) {
    const std::size_t files = shell.file_count();
    const Outcome outcome = shell.run(line);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_TRUE(is_one_complaint(outcome.err)) << line << '\n' << outcome.err;
    EXPECT_EQ(shell.file_count(), files) << line;
}

TEST(Mistakes, OnTheCommandLineAreRefused) {
    const Shell shell;
    for (const auto* line :
         {"scanlight --nonsense", "scanlight render", "scanlight info", "scanlight diff",
          "scanlight diff a.png", "scanlight steps", "scanlight gallery",
          "scanlight render cube a.png b.png", "scanlight info cube torus",
          "scanlight render cube --nonsense", "scanlight nosuchfile.obj out.png",
          "scanlight render nosuchfile.obj -o out.png", "scanlight info nosuchfile.obj",
          "scanlight info shape:nosuchshape", "scanlight info torus:1",
          "scanlight diff nosuch.png nosuch.png", "scanlight steps nosuchfile.obj",
          "scanlight render /dev/null -o out.png", "scanlight render . -o out.png"}) {
        expect_refused(shell, line);
    }
}

struct BadValues {
    std::string option;
    std::vector<std::string> values;
};

const std::vector<BadValues> bad_values{
    {"--size", {"0x0", "-1x5", "16385x1", "99999999999x1", "640x", "x", "nan", ""}},
    {"--shading", {"smooth", "", "Phong"}},
    {"--illumination", {"cook", "lambert,phong"}},
    {"--interpolation", {"planar"}},
    {"--perspective", {"yes"}},
    {"--cull", {"both"}},
    {"--sides", {"2"}},
    {"--distances", {"far"}},
    {"--normals", {"mine"}},
    {"--crease", {"-1", "181", "nan", "x"}},
    {"--material", {"kd=red", "shine=1", "n=nan", "kd"}},
    {"--view", {"30", "0,91", "nan,0", "a,b"}},
    {"--fov", {"0", "171", "nan", "inf", "wide"}},
    {"--lens", {"0", "-50", "nan"}},
    {"--projection", {"fisheye"}},
    {"--zoom", {"0", "-1", "nan", "inf"}},
    {"--eye", {"1,2", "1,2,nan", "1e300,0,0"}},
    {"--target", {"origin"}},
    {"--light", {"1,2", "moon:1,2,3", "1,2,3,#12", "1,2,3,cubic"}},
    {"--falloff-k", {"0", "-1", "nan"}},
    {"--gouraud71-k", {"0", "nan"}},
    {"--illumination cook-torrance --roughness", {"0", "1.1", "nan", "rough"}},
    {"--illumination cook-torrance --distribution", {"normal", ""}},
    {"--illumination cook-torrance --constant", {"4"}},
    {"--illumination cook-torrance --ior", {"0", "-1", "nan", "inf"}},
    {"--illumination cook-torrance --metal", {"brass", ""}},
    {"--illumination cook-torrance --reflectance", {"-1", "gold"}},
    {"--illumination cook-torrance --fresnel", {"slow"}},
    {"--illumination cook-torrance --specular-share", {"-0.1", "1.1", "nan"}},
    {"--ambient", {"-1", "1e300", "#12345", "nan"}},
    {"--background", {"clear", "#xyz"}},
    {"--shadows", {"volumes", "", "Map"}},
    {"--shadows map --shadow-map-size", {"0", "31", "8193", "1.5", "nan", ""}},
    {"--shadows map --shadow-bias", {"-1", "1001", "nan", "inf", "x"}},
    {"--shadows map --shadow-pcf", {"0", "2", "17", "-1", "nan", "1.5"}},
    {"--path", {"slow", "", "Fast"}},
    {"--threads", {"-1", "257", "1.5", "x", "nan", ""}},
    {"--instructions", {"MMX", "", "fastest"}},
};

TEST(Mistakes, InAnOptionOfTheSceneLeaveNoOutput) {
    const Shell shell;
    for (const auto& [option, values] : bad_values) {
        for (const auto& value : values) {
            expect_refused(
                shell, "scanlight render cube -s 8x8 -o out.png " + option + "='" + value + "'");
        }
    }
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(Mistakes, OfOptionsThatTheModelDoesNotKnowNameTheOneThatDoes) {
    const Shell shell;
    const auto expect_named = [&](const std::string& options, const std::string& model) {
        const std::string line = "scanlight render cube -s 8x8 -o out.png " + options;
        expect_refused(shell, line);
        EXPECT_NE(shell.run(line).err.find("--illumination " + model), std::string::npos) << line;
    };
    for (const std::string option :
         {"--roughness 0.3", "--distribution gauss", "--constant textbook", "--ior 1.4",
          "--metal gold", "--reflectance 0.9", "--fresnel fast", "--specular-share 0.5",
          "--show fresnel"}) {
        expect_named(option, "cook-torrance");
        expect_named(option + " --illumination blinn", "cook-torrance");
    }
    const std::string sees_through = "scanlight render cube -s 8x8 -o ok.png --environment room ";
    EXPECT_EQ(shell.run(sees_through + "--material refract=0.5 --ior 1.4").status, 0);
    for (const auto* material : {"kdt=0.5", "kt=0.5 nt=3", "kd=0.1 kdt=#fff"})
        expect_named(std::string("--material '") + material + "'", "hall");
    expect_refused(shell, "scanlight steps cube --roughness 0.3");
    for (const auto* two : {"--ior 1.4 --metal gold", "--metal gold --reflectance 0.9"})
        expect_refused(shell, std::string("scanlight render cube -o out.png "
                                          "--illumination cook-torrance ") +
                                  two);
}

TEST(Mistakes, InAnOptionOfStepsLeaveNoOutput) {
    const Shell shell;
    for (const auto* option :
         {"--size=0x0", "--fov=nan", "--polygon=0", "--polygon=7", "--polygon=-1", "--polygon=1.5",
          "--polygon=x", "--polygon=nan", "--polygon=99999999999", "--wireframe=hidden",
          "--wireframe", "--background=none", "--background=#fff"}) {
        expect_refused(shell, std::string("scanlight steps cube -o out.txt ") + option);
    }
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(Mistakes, InTheOutputsAreSaidBeforeTheWork) {
    const Shell shell;
    for (const auto* options :
         {"-o out.gif", "-o out", "-o png", "-o nosuchfolder/out.png", "--format gif -o out.png",
          "-o out.png --aov depth", "-o out.png --aov depth:", "-o out.png --aov alpha:a.png",
          "-o out.png --aov depth:z.gif", "-o out.png --stats xml", "-o out.png --wireframe=some",
          "-o out.pgm", "-o out.PGM", "-o out.png --aov normal:n.pgm", "-o out.png --aov id:i.pgm",
          "-o out.png --aov normal:n.hdr", "-o out.png --aov id:i.hdr"}) {
        expect_refused(shell, std::string("scanlight render cube -s 8x8 ") + options);
    }
    expect_refused(shell, "scanlight gallery pictures --panel 0x0");
    expect_refused(shell, "scanlight gallery pictures --only nosuchpicture");
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(Mistakes, InTheOutputAreSaidBeforeTheInputIsRead) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight render nosuchfile.obj -o out.gif");
    EXPECT_NE(outcome.err.find("out.gif"), std::string::npos) << outcome.err;
}

TEST(Mistakes, OfInstructionsNameThoseThereAre) {
    const std::string err = Shell().run("scanlight render cube -o out.png --instructions MMX").err;
    for (const auto name : render::instruction_sets())
        EXPECT_NE(err.find(name), std::string::npos) << err;
}

TEST(Mistakes, OfMeansThatTheTextbooksWalkHasNot) {
    const Shell shell;
    const std::string line = "scanlight render cube -s 8x8 -o out.png --path textbook ";
    expect_refused(shell, line + "--threads 2");
    for (const auto name : render::instruction_sets())
        expect_refused(shell, line + "--instructions " + std::string(name));
    EXPECT_EQ(shell.run(line + "--threads 1").status, 0);
}

TEST(Mistakes, OfShadowOptionsNameTheMethodThatHasThem) {
    const Shell shell;
    const std::vector<std::pair<std::string, std::string>> lines{
        {"render cube --shadow-bias 2", "--shadow-bias is for --shadows map"},
        {"render cube --shadows zfail --shadow-map-size 64",
         "--shadow-map-size is for --shadows map"},
        {"render cube --shadows polygons --shadow-pcf 3", "--shadow-pcf is for --shadows map"},
        {"steps cube --shadow-pcf 3", "--shadow-pcf is for --shadows map"},
        {"render cube --show details", "--show details is for --shadows polygons"},
        {"render cube --shadows zfail --show details", "--show details is for --shadows polygons"},
        {"render cube --shadows map --show stencil", "--show stencil counts shadow volumes"},
        {"render cube --shadows polygons --aov stencil:s.png",
         "--aov stencil counts shadow volumes"},
        {"steps cube --shadows map --pixel 1,1", "--pixel counts shadow volumes"}};
    for (const auto& [line, complaint] : lines) {
        expect_refused(shell, "scanlight " + line + " -o out.png");
        const std::string err = shell.run("scanlight " + line + " -o out.png").err;
        EXPECT_NE(err.find(complaint), std::string::npos) << line << '\n' << err;
    }
    EXPECT_EQ(shell.file_count(), 0u);
}

TEST(Mistakes, OfGreyForColoursNameWhatHoldsColours) {
    const Shell shell;
    for (const auto* line : {"scanlight render cube -o out.pgm", "scanlight cube out.pgm"}) {
        const std::string err = shell.run(line).err;
        for (const auto* ending : {".png", ".ppm", ".pfm", ".hdr"})
            EXPECT_NE(err.find(ending), std::string::npos) << err;
    }
}

TEST(Mistakes, OfABackgroundThatTheFormatCannotHoldAreSaid) {
    const Shell shell;
    for (const auto* output : {"-o out.ppm", "-o out.pfm", "-o out.hdr", "-o -",
                               "-o out.png --format ppm", "-o out --format pfm"}) {
        const std::string line =
            std::string("scanlight render cube -s 8x8 --background none ") + output;
        expect_refused(shell, line);
        EXPECT_NE(shell.run(line).err.find("--format png"), std::string::npos) << line;
    }
}

TEST(Mistakes, KeepAnOldFileAsItWas) {
    const Shell shell;
    shell.write("out.png", "not yet a picture");
    shell.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 900000\n");
    for (const auto* options : {"cube --size 0x0", "cube --fov nan", "cube --aov depth:z.gif",
                                "nosuchfile.obj", "broken.obj", "cube --wireframe=some"}) {
        expect_refused(shell, std::string("scanlight render -o out.png ") + options);
        EXPECT_EQ(shell.read("out.png"), "not yet a picture") << options;
    }
}

TEST(Mistakes, InAMeshFileNameTheFileAndTheLine) {
    const Shell shell;
    shell.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 900000\n");
    for (const auto* command : {"render", "info", "steps"}) {
        const Outcome outcome = shell.run(std::string("scanlight ") + command + " broken.obj");
        EXPECT_EQ(outcome.status, 2);
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
        EXPECT_NE(outcome.err.find("broken.obj:4"), std::string::npos) << outcome.err;
    }
}

// ---- standard output that takes nothing

const std::vector<std::string> printing_lines{
    "scanlight --help",
    "scanlight render --help",
    "scanlight --version",
    "scanlight info cube",
    "scanlight info cube --json",
    "scanlight steps cube --polygon 1",
    "scanlight render cube -s 8x8 -o -",
    "scanlight render cube -s 8x8 -o a.png -q --stats json",
    "scanlight diff b.png b.png"};

void expect_output_missed(const std::string& redirection) {
    const Shell shell;
    ASSERT_EQ(shell.run("scanlight render cube -s 8x8 -q -o b.png").status, 0);
    for (const auto& line : printing_lines) {
        const Outcome outcome = shell.run(line + redirection);
        EXPECT_EQ(outcome.status, 2) << line;
        EXPECT_TRUE(is_one_complaint(outcome.err)) << line << '\n' << outcome.err;
    }
}

TEST(StandardOutput, ThatIsFullIsAnError) {
    expect_output_missed(" >/dev/full");
}

TEST(StandardOutput, ThatIsClosedIsAnError) {
    expect_output_missed(" >&-");
}

// ---- surroundings

TEST(Surroundings, AGermanLocaleChangesNothing) {
    const Shell shell;
    const std::string german = "LOCPATH=$PWD LC_ALL=de_DE.UTF-8 ";
    shell.run("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8");
    if (shell.run(german + "bash -c \"printf %.1f '0,5'\"").out != "0,5") {
        GTEST_SKIP() << "a German locale cannot be made here";
    }
    for (const auto* line : {"scanlight steps shape:star --view 0,0", "scanlight info teapot",
                             "scanlight render cube -s 16x16 --fov 33.5 --zoom 0.5 -o -"}) {
        const Outcome plain = shell.run(std::string("LC_ALL=C ") + line);
        const Outcome same = shell.run(german + line);
        EXPECT_EQ(plain.status, 0);
        EXPECT_EQ(same.status, 0) << same.err;
        EXPECT_EQ(plain.out, same.out);
    }
}

}  // namespace
}  // namespace scanlight::apps
