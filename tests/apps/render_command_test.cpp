#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "mesh/solids.h"
#include "raster/compare.h"
#include "raster/load_image.h"
#include "render/renderer.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

using Json = nlohmann::json;
using raster::Image16;
using raster::Image8;
using raster::ImageF;

/// Runs a line that must succeed.
Outcome run(const Shell& shell, const std::string& line) {
    Outcome outcome = shell.run(line);
    EXPECT_EQ(outcome.status, 0) << line << '\n' << outcome.err;
    return outcome;
}

template <class Image>
Image load(const Shell& shell, const std::string& name) {
    const raster::AnyImage any = raster::load_image(shell / name);
    if (!std::holds_alternative<Image>(any)) {
        ADD_FAILURE() << name << " holds other samples";
        return Image(1, 1, 1);
    }
    return std::get<Image>(any);
}

template <class Image>
void expect_shape(const Image& image, int width, int height, int channels) {
    EXPECT_EQ(image.width(), width);
    EXPECT_EQ(image.height(), height);
    EXPECT_EQ(image.channels(), channels);
}

const std::string tetrahedron_obj =
    "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

// ---- the picture

TEST(Render, WritesAPictureOfTheSizeAskedFor) {
    const Shell shell;
    run(shell, "scanlight render cube -o a.png -s 40x30");
    const auto image = load<Image8>(shell, "a.png");
    expect_shape(image, 40, 30, 3);
    const std::set<int> reds(image.samples().begin(), image.samples().end());
    EXPECT_GT(reds.size(), 4u) << "a picture of one colour";
    EXPECT_EQ(shell.file_count(), 1u);
}

TEST(Render, OfInAndOutNeedsNoCommand) {
    const Shell shell;
    shell.write("t.obj", tetrahedron_obj);
    run(shell, "scanlight t.obj a.png -s 16x12");
    run(shell, "scanlight render t.obj -o b.png -s 16x12");
    run(shell, "scanlight render t.obj b2.png --size 16x12");
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
    EXPECT_EQ(shell.read("a.png"), shell.read("b2.png"));
}

TEST(Render, NamesItsOutputAfterItsInput) {
    const Shell shell;
    shell.run("mkdir models a:b");
    shell.write("models/my.mesh.obj", tetrahedron_obj);
    shell.write("a:b/t.obj", tetrahedron_obj);
    const std::pair<std::string, std::string> names[] = {
        {"cube", "cube.png"},       {"shape:cone", "cone.png"},
        {"torus:8,5", "torus.png"}, {"models/my.mesh.obj", "my.mesh.png"},
        {"a:b/t.obj", "t.png"},     {"- < models/my.mesh.obj", "scanlight.png"},
    };
    for (const auto& [input, output] : names) {
        run(shell, "scanlight render -s 8x8 " + input);
        EXPECT_TRUE(shell.has(output)) << output;
    }
}

TEST(Render, SaysOneLineUnlessQuiet) {
    const Shell shell;
    const Outcome loud = run(shell, "scanlight render cube -s 8x8 -o a.png");
    EXPECT_EQ(loud.out, "");
    EXPECT_NE(loud.err.find("a.png: 8x8, 6 of 6 polygons drawn"), std::string::npos) << loud.err;
    const Outcome quiet = run(shell, "scanlight render cube -s 8x8 -o a.png --quiet");
    EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST(Render, SaysHowManyFacesAreLeftOut) {
    const Shell shell;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto last_line = [&](const std::string& faces) {
        shell.write("t.obj", points + faces);
        const std::string err = run(shell, "scanlight render t.obj -o a.png -s 8x8").err;
        return err.substr(err.rfind("a.png"));
    };
    EXPECT_TRUE(last_line("f 1 2 3\n").ends_with(" ms\n"));
    const std::string some = last_line("f 1 2 3\nf 1 1 2\n");
    EXPECT_TRUE(some.starts_with("a.png: 8x8, 1 of 1 polygons drawn in ")) << some;
    EXPECT_TRUE(some.ends_with(", 1 of the file's 2 faces left out\n")) << some;
    EXPECT_EQ(last_line("f 1 1 2\nf 1 2 2\n"),
              "a.png: 8x8, no polygon to draw, 2 of the file's 2 faces left out\n");
    EXPECT_EQ(last_line(""), "a.png: 8x8, no polygon to draw, as the file has no faces\n");
}

TEST(Render, SaysWhatStandsInForNormalsThatAreMissing) {
    const Shell shell;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    const auto said = [&](const std::string& face, const std::string& options) {
        shell.write("t.obj", points + face);
        const Outcome outcome = run(shell, "scanlight render t.obj -o a.png -s 8x8 " + options);
        return outcome.err.substr(0, outcome.err.rfind("a.png"));
    };
    const std::string instead = "; the mean of the faces' normals is taken instead\n";
    EXPECT_EQ(said("f 1 2 3\n", "--normals file"), "scanlight: t.obj: brings no normals" + instead);
    EXPECT_EQ(said("f 1//1 2 3//1\n", "--normals file"),
              "scanlight: t.obj: brings no normals for 1 of 3 corners" + instead);
    EXPECT_EQ(said("f 1//1 2//1 3//1\n", "--normals file"), "");
    EXPECT_EQ(said("f 1 2 3\n", "--normals area"), "");
    EXPECT_EQ(run(shell, "scanlight render t.obj -o a.png -s 8x8 --normals file -q").err, "");
}

TEST(Render, DashWritesAPpmToStandardOutputAndNothingElse) {
    const Shell shell;
    const Outcome outcome = run(shell, "scanlight render cube -s 20x10 -o -");
    EXPECT_TRUE(outcome.out.starts_with("P6\n20 10\n255\n")) << outcome.out.substr(0, 20);
    EXPECT_EQ(outcome.out.size(), std::string("P6\n20 10\n255\n").size() + 20 * 10 * 3);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(shell.file_count(), 0u);
    run(shell, "scanlight render cube -s 20x10 -o a.png -q");
    shell.write("b.ppm", outcome.out);
    EXPECT_EQ(load<Image8>(shell, "a.png"), load<Image8>(shell, "b.ppm"));
}

TEST(Render, ReadsAMeshFromStandardInput) {
    const Shell shell;
    shell.write("t.obj", tetrahedron_obj);
    run(shell, "scanlight render t.obj -o a.png -s 16x12");
    run(shell, "cat t.obj | scanlight render - -o b.png -s 16x12");
    run(shell, "scanlight - c.png -s 16x12 < t.obj");
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
    EXPECT_EQ(shell.read("a.png"), shell.read("c.png"));
}

TEST(Render, AFileNamedLikeAShapeComesFirst) {
    const Shell shell;
    run(shell, "scanlight render cube -o shape.png -s 16x12");
    shell.write("cube", tetrahedron_obj);
    run(shell, "scanlight render cube -o file.png -s 16x12");
    run(shell, "scanlight render shape:cube -o prefixed.png -s 16x12");
    EXPECT_EQ(shell.read("shape.png"), shell.read("prefixed.png"));
    EXPECT_NE(shell.read("shape.png"), shell.read("file.png"));
    // A folder of that name is not a mesh.
    shell.run("mkdir torus");
    run(shell, "scanlight render torus -o torus.png -s 8x8");
}

TEST(Render, TheSmallestPictureIsOnePixel) {
    const Shell shell;
    run(shell, "scanlight render sphere -o a.png -s 1x1");
    expect_shape(load<Image8>(shell, "a.png"), 1, 1, 3);
}

TEST(Render, EachFormatHoldsThePicture) {
    const Shell shell;
    run(shell, "scanlight render cube -o a.png -s 12x8");
    run(shell, "scanlight render cube -o a.ppm -s 12x8");
    run(shell, "scanlight render cube -o a.pfm -s 12x8");
    run(shell, "scanlight render cube -o a.hdr -s 12x8");
    run(shell, "scanlight render cube -o named --format png -s 12x8");
    EXPECT_EQ(load<Image8>(shell, "a.png"), load<Image8>(shell, "a.ppm"));
    EXPECT_EQ(shell.read("a.png"), shell.read("named"));
    expect_shape(load<ImageF>(shell, "a.pfm"), 12, 8, 3);
    expect_shape(load<ImageF>(shell, "a.hdr"), 12, 8, 3);
}

TEST(Render, WithoutBackgroundThereIsAlpha) {
    const Shell shell;
    run(shell, "scanlight render ngon:64 --view 0,0 -o a.png -s 32x32 --background none");
    const auto image = load<Image8>(shell, "a.png");
    expect_shape(image, 32, 32, 4);
    EXPECT_EQ(image.pixel(0, 0)[3], 0);
    EXPECT_EQ(image.pixel(16, 16)[3], 255);
    run(shell, "scanlight render ngon:64 -o b.ppm -s 32x32 --background none --format png");
    expect_shape(load<Image8>(shell, "b.ppm"), 32, 32, 4);
}

TEST(Render, APolygonIsSeenFromItsSideWhicheverWayRoundItIsSaid) {
    const Shell shell;
    const std::string options = " --view 0,0 --cull back -s 32x24 -o ";
    run(shell, "scanlight render polygon:0,1:-1,-1:0.5,-0.25" + options + "a.png");
    run(shell, "scanlight render polygon:0,1:0.5,-0.25:-1,-1" + options + "b.png");
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
}

TEST(Render, APolygonWithoutAnAreaIsRefusedInOneLine) {
    const Shell shell;
    for (const char* polygon : {"0,0:1,1:2,2", "0,0:1,1", "0,0:1,0:nan,1", "0,0:1,0:0;1"}) {
        const Outcome outcome =
            shell.run("scanlight render 'polygon:" + std::string(polygon) + "' -o a.png");
        EXPECT_EQ(outcome.status, 2) << polygon;
        EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    }
    EXPECT_FALSE(shell.has("a.png"));
}

TEST(Render, TheBackgroundIsTheColourAskedFor) {
    const Shell shell;
    run(shell, "scanlight render ngon:64 --view 0,0 -o a.png -s 32x32 --background '#102030'");
    const auto image = load<Image8>(shell, "a.png");
    EXPECT_EQ(image.pixel(0, 0)[0], 0x10);
    EXPECT_EQ(image.pixel(0, 0)[1], 0x20);
    EXPECT_EQ(image.pixel(0, 0)[2], 0x30);
}

TEST(Render, TwoRunsGiveTheSameBytes) {
    const Shell shell;
    const std::string options = " -s 60x40 --aov depth:z.pfm --aov normal:n.png --aov id:i.png";
    run(shell, "mkdir 1 2");
    run(shell, "cd 1 && scanlight render teapot:4 -o a.png" + options);
    run(shell, "cd 2 && scanlight render teapot:4 -o a.png" + options);
    for (const auto* name : {"a.png", "z.pfm", "n.png", "i.png"}) {
        EXPECT_EQ(shell.read(std::string("1/") + name), shell.read(std::string("2/") + name));
        EXPECT_NE(shell.read(std::string("1/") + name), "");
    }
}

TEST(Render, EachChoiceChangesThePicture) {
    const Shell shell;
    const std::string line = "scanlight render torus:10,6 -q -s 48x36 -o ";
    run(shell, line + "plain.png");
    for (const auto* option : {"--shading flat",
                               "--shading gouraud",
                               "--illumination lambert",
                               "--illumination blinn",
                               "--illumination gouraud71",
                               "--illumination hall",
                               "--illumination cook-torrance",
                               "--interpolation triangulated --shading gouraud",
                               "--perspective affine",
                               "--cull front",
                               "--distances infinite",
                               "--crease 0",
                               "--material 'kd=#fff'",
                               "--view 10,60",
                               "--fov 60",
                               "--lens 85",
                               "--projection orthographic",
                               "--zoom 2",
                               "--eye 3,3,3",
                               "--light 1,0,0",
                               "--ambient 0.5",
                               "--background '#fff'",
                               "--wireframe",
                               "--wireframe=hidden",
                               "--wireframe=over"}) {
        run(shell, line + "other.png " + option);
        EXPECT_EQ(shell.run("scanlight diff plain.png other.png").status, 1) << option;
    }
}

TEST(Render, EachChoiceOfShadowsChangesThePicture) {
    const Shell shell;
    const std::string line = "scanlight render torus:10,6 --floor --view 25,35 -q -s 48x36 -o ";
    run(shell, line + "map.png --shadows map --shadow-map-size 128");
    for (const auto* option : {"", "--shadows map --shadow-map-size 40",
                               "--shadows map --shadow-map-size 128 --shadow-bias 0",
                               "--shadows map --shadow-map-size 128 --shadow-pcf 3",
                               "--shadows polygons", "--shadows polygons --show details"}) {
        run(shell, line + "other.png " + option);
        EXPECT_EQ(shell.run("scanlight diff map.png other.png").status, 1) << option;
    }
}

TEST(Render, DetailsAreOutlinedInFilesOfFloatsToo) {
    const Shell shell;
    run(shell, "scanlight render cube --floor --shadows polygons --show details -s 24x16 -o d.pfm");
    expect_shape(load<ImageF>(shell, "d.pfm"), 24, 16, 3);
}

/// Each of the options, beside those that choose the model.
void expect_changes(const std::string& model, const std::vector<std::string>& options) {
    const Shell shell;
    const std::string line =
        "scanlight render torus:10,6 -q -s 48x36 --light 1,1,-1 --light 0,1,1 " + model + " -o ";
    run(shell, line + "plain.png");
    for (const std::string& option : options) {
        run(shell, line + "other.png " + option);
        EXPECT_EQ(shell.run("scanlight diff plain.png other.png").status, 1) << option;
    }
}

TEST(Render, EachChoiceOfAModelChangesThePicture) {
    expect_changes("--illumination cook-torrance",
                   {"--roughness 0.4", "--distribution gauss", "--distribution cosine",
                    "--constant textbook", "--ior 1.2", "--metal copper", "--reflectance 0.9",
                    "--specular-share 0.9", "--show fresnel"});
    expect_changes("--illumination cook-torrance --metal gold", {"--fresnel fast"});
    expect_changes("--illumination hall", {"--material 'kdt=0.5'", "--material 'kt=0.5 nt=9'"});
    expect_changes("--illumination hall --material 'kt=0.5 nt=4'", {"--ior 1.3"});
}

TEST(Render, TheShapesFirstSideIsTheOnlyOneLit) {
    const Shell shell;
    const std::string line = "scanlight render plane:2 --view 30,-40 -q -s 24x16 -o ";
    run(shell, line + "two.png");
    run(shell, line + "one.png --sides one");
    EXPECT_EQ(shell.run("scanlight diff one.png two.png").status, 1);
}

TEST(Render, CulledPolygonsShowNoEdges) {
    const Shell shell;
    const std::string line = "scanlight render cube -q -s 48x36 --wireframe -o ";
    run(shell, line + "all.png");
    run(shell, line + "culled.png --cull back");
    EXPECT_EQ(shell.run("scanlight diff all.png culled.png").status, 1);
}

// ---- the two paths

/// Draws what the options say, bytes, floats and depths, into files of these names.
void draw_all(const Shell& shell, const std::string& options, const std::string& name) {
    const std::string line = "scanlight render -q -s 61x47 " + options + " -o " + name;
    run(shell, line + ".png --aov depth:" + name + "-z.pfm");
    run(shell, line + ".pfm");
}

void expect_same_files(const Shell& shell, const std::string& name, const std::string& other,
                       const std::string& what) {
    for (const auto* ending : {".png", "-z.pfm", ".pfm"}) {
        EXPECT_NE(shell.read(name + ending), "") << what;
        EXPECT_TRUE(shell.read(name + ending) == shell.read(other + ending)) << what << ending;
    }
}

TEST(Paths, DrawTheSameFiles) {
    const Shell shell;
    for (const std::string options :
         {"teapot:3", "teapot:3 --shading flat --cull back", "star:9 --shading gouraud",
          "torus:10,6 --shading gouraud --sides one --view 30,-40",
          "cube --shading gouraud --interpolation triangulated --perspective affine",
          "plane:2 --eye 0,0.3,0.4 --target 0,0,0 --illumination blinn --light point:0,0.4,0",
          "sphere:9,5 --illumination cook-torrance --metal gold --distribution gauss",
          "sphere:9,5 --illumination cook-torrance --shading gouraud --show fresnel",
          "torus:9,5 --illumination hall --material 'kdt=0.5 kt=0.3 nt=9' --light 0,1,-1",
          "sphere:9,5 --illumination gouraud71 --shading gouraud --distances infinite",
          "teapot:3 --floor --shadows map", "cube --floor --shadows map --shadow-pcf 3",
          "cube --floor --shadows polygons --show details", "teapot:3 --floor --shadows polygons",
          "cylinder:7 --wireframe=over", "cylinder:7 --wireframe=hidden --cull back"}) {
        draw_all(shell, options + " --path fast", "fast");
        draw_all(shell, options + " --path textbook", "textbook");
        expect_same_files(shell, "fast", "textbook", options);
    }
}

TEST(Paths, DrawTheSameAlpha) {
    const Shell shell;
    const std::string line = "scanlight render ngon:64 --view 0,0 -s 32x32 --background none -o ";
    run(shell, line + "fast.png");
    run(shell, line + "textbook.png --path textbook");
    EXPECT_EQ(shell.read("fast.png"), shell.read("textbook.png"));
}

TEST(Paths, DrawTheSameByAnyThreadsAndInstructions) {
    const Shell shell;
    const std::string options = "teapot:3 --shading gouraud ";
    draw_all(shell, options, "a");
    for (const auto* threads : {"0", "1", "3", "16"}) {
        for (const auto instructions : render::instruction_sets()) {
            const std::string means = std::string("--threads ") + threads + " --instructions " +
                                      std::string(instructions);
            draw_all(shell, options + means, "b");
            expect_same_files(shell, "a", "b", means);
        }
    }
}

// ---- data

TEST(Aov, DepthIsSixteenBitsOrADistance) {
    const Shell shell;
    run(shell,
        "scanlight render ngon:64 --eye 0,0,4 --target 0,0,0 -o a.png -s 32x24"
        " --aov depth:z.png --aov depth:z.pfm");
    const auto grey = load<Image16>(shell, "z.png");
    expect_shape(grey, 32, 24, 1);
    EXPECT_EQ(grey.pixel(0, 0)[0], 65535);
    EXPECT_LT(grey.pixel(16, 12)[0], 65535);
    const auto distance = load<ImageF>(shell, "z.pfm");
    expect_shape(distance, 32, 24, 1);
    EXPECT_EQ(distance.pixel(0, 0)[0], 0.0f);
    EXPECT_NEAR(distance.pixel(16, 12)[0], 4.0f, 1e-4f);
}

TEST(Aov, DepthMayBeANetpbmOfGrey) {
    const Shell shell;
    run(shell, "scanlight render cube -o a.png -s 8x6 --aov depth:z.pgm --aov depth:z.png");
    EXPECT_TRUE(shell.read("z.pgm").starts_with("P5\n8 6\n65535\n"));
    EXPECT_EQ(load<Image16>(shell, "z.pgm"), load<Image16>(shell, "z.png"));
}

TEST(Aov, NormalIsAColourOrAVector) {
    const Shell shell;
    run(shell,
        "scanlight render ngon:64 --view 0,0 -o a.png -s 32x24"
        " --aov normal:n.png --aov normal:n.pfm");
    const auto color = load<Image8>(shell, "n.png");
    expect_shape(color, 32, 24, 3);
    const auto middle = color.pixel(16, 12);
    EXPECT_EQ(std::vector<int>(middle.begin(), middle.end()), (std::vector<int>{128, 128, 255}));
    EXPECT_EQ(color.pixel(0, 0)[2], 0);
    const auto vector = load<ImageF>(shell, "n.pfm");
    expect_shape(vector, 32, 24, 3);
    EXPECT_EQ(vector.pixel(16, 12)[0], 0.0f);
    EXPECT_EQ(vector.pixel(16, 12)[2], 1.0f);
    EXPECT_EQ(vector.pixel(0, 0)[2], 0.0f);
}

TEST(Aov, IdIsTheNumberOfThePolygon) {
    const Shell shell;
    run(shell, "scanlight render sphere:64,32 -o a.png -s 64x48 --aov id:i.png --aov id:i.pfm");
    const auto bytes = load<Image8>(shell, "i.png");
    const auto floats = load<ImageF>(shell, "i.pfm");
    expect_shape(bytes, 64, 48, 3);
    expect_shape(floats, 64, 48, 1);
    std::set<int> ids;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto p = bytes.pixel(x, y);
            const int id = (p[0] << 16) + (p[1] << 8) + p[2];
            ASSERT_EQ(static_cast<float>(id), floats.pixel(x, y)[0]);
            ids.insert(id);
        }
    }
    EXPECT_EQ(*ids.begin(), 0);
    EXPECT_GT(*ids.rbegin(), 256);  // of 64 * 32, so the second byte is at work
    EXPECT_LE(*ids.rbegin(), 64 * 32);
    EXPECT_GT(ids.size(), 300u);
}

// ---- statistics

TEST(Stats, AsJsonAreOnStandardOutput) {
    const Shell shell;
    const Outcome outcome =
        run(shell, "scanlight render cube -o a.png -s 32x24 -q --stats json --cull back");
    const Json stats = Json::parse(outcome.out);
    EXPECT_EQ(stats["input"], "cube");
    EXPECT_EQ(stats["width"], 32);
    EXPECT_EQ(stats["height"], 24);
    EXPECT_EQ(stats["faces"]["in_file"], 6);
    EXPECT_EQ(stats["polygons"]["in"], 6);
    EXPECT_EQ(stats["polygons"]["drawn"].get<int>() + stats["polygons"]["culled"].get<int>(), 6);
    EXPECT_GT(stats["polygons"]["drawn"], 0);
    EXPECT_GT(stats["spans"], 10);
    EXPECT_LE(stats["pixels"]["passed"], stats["pixels"]["tested"]);
    EXPECT_LE(stats["pixels"]["passed"], 32 * 24);
    for (const auto& [name, time] : stats["milliseconds"].items()) {
        EXPECT_GE(time.get<double>(), 0.0) << name;
        EXPECT_LT(time.get<double>(), 60000.0) << name;
        EXPECT_LE(time.dump().size(), 14u) << "more digits than a float has: " << time.dump();
    }
}

Json stats_of(const Shell& shell, const std::string& options) {
    return Json::parse(
        run(shell, "scanlight render cube -o a.png -s 32x24 -q --stats json " + options).out);
}

TEST(Stats, OfTheFastPathTellItsMeansStagesAndMemory) {
    const Json stats = stats_of(Shell(), "--threads 3");
    EXPECT_EQ(stats["path"], "fast");
    EXPECT_EQ(stats["threads"], 3);
    EXPECT_EQ(stats["instructions"], render::instruction_sets().front());
    EXPECT_EQ(stats["megapixels"], 32 * 24 / 1e6);
    EXPECT_GT(stats["pixels"]["shaded"], 0);
    EXPECT_LE(stats["pixels"]["shaded"], stats["pixels"]["passed"]);
    const Json& times = stats["milliseconds"];
    double stages = 0.0;
    for (const auto* stage : {"vertices", "bins", "shadows", "bands"})
        stages += times[stage].get<double>();
    EXPECT_GT(stages, 0.0);
    EXPECT_LE(stages, times["draw"].get<double>());
    EXPECT_TRUE(stats["memory"]["working_bytes"].is_number_unsigned());
    EXPECT_GT(stats["memory"]["peak_bytes"], 1'000'000);
    EXPECT_LT(stats["memory"]["peak_bytes"], 1'000'000'000);
}

TEST(Stats, OfTheTextbooksWalkTellNoStages) {
    for (const auto* options : {"--path textbook", "--wireframe", "--wireframe=hidden"}) {
        const Json stats = stats_of(Shell(), options);
        EXPECT_EQ(stats["path"], "textbook") << options;
        EXPECT_EQ(stats["threads"], 1);
        EXPECT_EQ(stats["instructions"], nullptr);
        EXPECT_EQ(stats["milliseconds"]["bands"], nullptr);
        EXPECT_EQ(stats["memory"]["working_bytes"], nullptr);
        EXPECT_GT(stats["memory"]["peak_bytes"], 1'000'000);
        EXPECT_GT(stats["pixels"]["passed"], 0);
    }
}

TEST(Stats, LeaveStandardOutputToThePicture) {
    const Shell shell;
    const Outcome outcome = run(shell, "scanlight render cube -o - -s 8x8 --stats json");
    EXPECT_TRUE(outcome.out.starts_with("P6\n8 8\n255\n"));
    EXPECT_EQ(outcome.out.size(), std::string("P6\n8 8\n255\n").size() + 8 * 8 * 3);
    EXPECT_EQ(Json::parse(outcome.err)["polygons"]["in"], 6);
}

TEST(Stats, AsTextHaveOneNumberALine) {
    const Shell shell;
    const Outcome outcome = run(shell, "scanlight render cube -o a.png -s 8x8 -q --stats text");
    EXPECT_NE(outcome.out.find("\npolygons.in 6\n"), std::string::npos) << outcome.out;
}

TEST(Stats, TakeAnyFileName) {
    const Shell shell;
    shell.write("caf\xe9.obj", tetrahedron_obj);  // Latin-1
    const Outcome outcome =
        run(shell, "scanlight render caf\xe9.obj -o a.png -s 8x8 -q --stats json");
    EXPECT_EQ(Json::parse(outcome.out)["faces"]["in_file"], 4);
}

}  // namespace
}  // namespace scanlight::apps
