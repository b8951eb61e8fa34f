#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "raster/load_image.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

using Json = nlohmann::json;

std::string output_of(const Shell& shell, const std::string& line) {
    const Outcome outcome = shell.run(line);
    EXPECT_EQ(outcome.status, 0) << line << '\n' << outcome.err;
    return outcome.out;
}

// ---- text

TEST(StepsText, OfAStarIsThePrintedOne) {
    const std::filesystem::path golden = SCANLIGHT_TESTS_DIR "/apps/steps_star.txt";
    const std::string actual = output_of(
        Shell(), "scanlight steps shape:star --view 0,0 --light point:0.5,1,0.5 --size 20x12");
    const std::filesystem::path seen = SCANLIGHT_BUILD_DIR "/golden-failures/steps_star.txt";
    if (actual == contents_of(golden)) return;
    std::filesystem::create_directories(seen.parent_path());
    put(seen, actual);
    ADD_FAILURE() << "the text has changed: diff " << golden << ' ' << seen << "\nto accept it: cp "
                  << seen << ' ' << golden;
}

TEST(StepsText, GoesToAFileToo) {
    const Shell shell;
    const std::string printed = output_of(shell, "scanlight steps ngon:3");
    EXPECT_EQ(output_of(shell, "scanlight steps ngon:3 -o steps.txt"), "");
    EXPECT_EQ(shell.read("steps.txt"), printed);
}

TEST(StepsText, OfSeveralPolygonsSaysWhichItShows) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight steps cube");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("6 polygons are seen"), std::string::npos);
    EXPECT_TRUE(outcome.out.starts_with("Polygon ")) << outcome.out;
}

TEST(StepsText, OfAllPolygonsHasOneTitleEach) {
    const std::string text = output_of(Shell(), "scanlight steps cube --polygon all");
    for (const auto* title : {"Polygon 1 of cube", "Polygon 6 of cube"})
        EXPECT_NE(text.find(title), std::string::npos) << title;
}

TEST(StepsText, SaysWhatTheFileLacks) {
    const Shell shell;
    shell.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    const Outcome plain = shell.run("scanlight steps t.obj");
    EXPECT_NE(plain.err.find("1 of 2 faces are left out"), std::string::npos) << plain.err;
    const Outcome outcome = shell.run("scanlight steps t.obj --normals file");
    EXPECT_NE(outcome.err.find("t.obj: brings no normals;"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, plain.out);
}

TEST(StepsText, OfNothingSeenIsEmpty) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight steps plane:1 --view 0,-40 --cull back");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    const Json json =
        Json::parse(shell.run("scanlight steps plane:1 --view 0,-40 --cull back --json").out);
    EXPECT_EQ(json["polygons"], Json::array());
    EXPECT_EQ(json["header"]["polygons_seen"], 0);
    EXPECT_EQ(json["header"]["polygon_numbers"], Json::array());
}

// ---- JSON

Json steps_document(const std::string& options) {
    return Json::parse(output_of(Shell(), "scanlight steps --json " + options));
}

Json steps_json(const std::string& options) {
    return steps_document(options)["polygons"];
}

using Numbers = std::map<std::string, double>;

Numbers numbers(const Json& json) {
    Numbers result;
    for (const auto& [name, value] : json.items())
        result[name] = value.get<double>();
    return result;
}

void expect_steps_to(const Json& item, const Json& next) {
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(item["z"].get<double>() + item["dz"].get<double>(), next["z"].get<double>(),
                rounding);
    const Numbers values = numbers(item["values"]);
    const Numbers increments = numbers(item["increments"]);
    const Numbers expected = numbers(next["values"]);
    ASSERT_EQ(values.size(), expected.size());
    for (const auto& [name, value] : values)
        EXPECT_NEAR(value + increments.at(name), expected.at(name), rounding) << name;
}

const Json* edge_from(const Json& line, const Json& from) {
    for (const Json& edge : line["active"]) {
        if (edge["from"] == from) return &edge;
    }
    return nullptr;
}

/// Each active edge plus its increments is the same edge on the next scanline.
void expect_edges_to_step(const Json& polygon) {
    const Json& lines = polygon["scanlines"];
    std::size_t followed = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        for (const Json& edge : lines[i]["active"]) {
            const Json* next = edge_from(lines[i + 1], edge["from"]);
            EXPECT_EQ(next != nullptr, edge["y_end"].get<int>() > lines[i + 1]["y"].get<int>());
            if (!next) continue;
            EXPECT_NEAR(edge["x"].get<double>() + edge["dx"].get<double>(),
                        (*next)["x"].get<double>(), 1e-9);
            expect_steps_to(edge, *next);
            ++followed;
        }
    }
    EXPECT_GT(followed, 10u);
}

/// From the value of the left edge, over the pre-step to the first centre, a span's increments
/// arrive at the value of the right edge.
void expect_span_between(const Json& left, const Json& right, const Json& span) {
    const double first = span["x_begin"].get<double>() + 0.5;
    const double pixels = span["x_end"].get<double>() - span["x_begin"].get<double>();
    EXPECT_GE(first, left["x"].get<double>() - 1e-9);
    EXPECT_LT(first - 1.0, left["x"].get<double>());
    EXPECT_LT(first + pixels - 1.0, right["x"].get<double>());
    if (pixels < 2) return;  // takes no step
    const Numbers steps = numbers(span["increments"]);
    for (const auto& [name, value] : numbers(span["values"])) {
        const double back = first - left["x"].get<double>();
        const double ahead = right["x"].get<double>() - first;
        EXPECT_NEAR(value - back * steps.at(name), left["values"][name].get<double>(), 1e-9);
        EXPECT_NEAR(value + ahead * steps.at(name), right["values"][name].get<double>(), 1e-9);
    }
}

/// The pair of edges that bounds a span.
void expect_spans_between_edges(const Json& polygon) {
    std::size_t checked = 0;
    for (const Json& line : polygon["scanlines"]) {
        const Json& active = line["active"];
        ASSERT_EQ(active.size() % 2, 0u);
        for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
            EXPECT_LE(active[i]["x"], active[i + 1]["x"]);
            for (const Json& span : line["spans"]) {
                const double middle =
                    0.5 * (span["x_begin"].get<double>() + span["x_end"].get<double>());
                if (middle < active[i]["x"] || middle > active[i + 1]["x"]) continue;
                expect_span_between(active[i], active[i + 1], span);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 5u);
}

TEST(StepsJson, IncrementsAddUpToTheNextScanline) {
    for (const auto* options :
         {"shape:star --view 0,0 --light point:0.5,1,0.5", "ngon:3 --view 10,30 --shading phong",
          "ngon:7 --view 40,-20 --shading flat", "star:9 --view 20,35 --size 60x60",
          "torus:8,5 --size 80x60 --perspective correct"}) {
        SCOPED_TRACE(options);
        const Json polygons = steps_json(options);
        ASSERT_EQ(polygons.size(), 1u);
        expect_edges_to_step(polygons[0]);
        expect_spans_between_edges(polygons[0]);
    }
}

TEST(StepsJson, BucketsAreWhereTheirEdgesBecomeActive) {
    const Json polygon = steps_json("shape:star --view 0,0")[0];
    for (const Json& waiting : polygon["edge_table"]) {
        for (const Json& line : polygon["scanlines"]) {
            const int y = line["y"].get<int>();
            const bool active = edge_from(line, waiting["from"]) != nullptr;
            EXPECT_EQ(active,
                      y >= waiting["y_begin"].get<int>() && y < waiting["y_end"].get<int>());
        }
    }
}

TEST(StepsJson, SpansAreThePixelsOfThePicture) {
    const Shell shell;
    const std::string view = " shape:star --view 20,10 --size 40x30";
    const Json polygon =
        Json::parse(output_of(shell, "scanlight steps --json" + view))["polygons"][0];
    output_of(shell, "scanlight render -o a.png --aov id:i.pfm -q" + view);
    const auto ids = std::get<raster::ImageF>(raster::load_image(shell / "i.pfm"));
    std::vector<int> covered(40 * 30, 0);
    for (const Json& line : polygon["scanlines"]) {
        for (const Json& span : line["spans"]) {
            for (int x = span["x_begin"]; x < span["x_end"]; ++x)
                covered[line["y"].get<std::size_t>() * 40 + static_cast<std::size_t>(x)] += 1;
        }
    }
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            ASSERT_EQ(static_cast<float>(covered[static_cast<std::size_t>(y * 40 + x)]),
                      ids.pixel(x, y)[0]);
        }
    }
}

TEST(StepsJson, GreyLightIsOneIntensity) {
    const auto names = [](const std::string& options) {
        const Json polygons = steps_json(options);
        std::vector<std::string> result;
        for (const auto& [name, value] : polygons[0]["corners"][0]["values"].items())
            result.push_back(name);
        return result;
    };
    EXPECT_EQ(names("ngon:3"), std::vector<std::string>{"I"});
    EXPECT_EQ(names("ngon:3 --light '0,0,1,#f00'"),
              (std::vector<std::string>{"I_b", "I_g", "I_r"}));
    EXPECT_EQ(names("ngon:3 --shading phong"), (std::vector<std::string>{"N_x", "N_y", "N_z"}));
    EXPECT_EQ(names("ngon:3 --shading flat"), std::vector<std::string>{});
}

TEST(StepsJson, SaysWhatItShows) {
    const Json header = steps_document(
        "cube --size 30x20 --view 40,-10 --polygon 4 --shading phong "
        "--interpolation bilinear --perspective correct "
        "--illumination blinn")["header"];
    const Json expected{
        {"scanlight", header["scanlight"]},
        {"input", "cube"},
        {"size", {{"width", 30}, {"height", 20}}},
        {"view", {{"projection", "perspective"}, {"azimuth_deg", 40.0}, {"elevation_deg", -10.0}}},
        {"polygons_seen", 6},
        {"polygon_numbers", {4}},
        {"shading", "phong"},
        {"illumination", "blinn"},
        {"interpolation", "bilinear"},
        {"perspective", "correct"}};
    EXPECT_EQ(header, expected);
    EXPECT_EQ("scanlight " + header["scanlight"].get<std::string>() + "\n",
              output_of(Shell(), "scanlight --version"));
}

TEST(StepsJson, SaysFromWhereACameraThatWasPlacedLooks) {
    const Json header = steps_document(
        "cube --eye 0,1,6 --projection orthographic "
        "--interpolation triangulated --polygon all")["header"];
    EXPECT_EQ(header["view"], Json({{"projection", "orthographic"},
                                    {"eye", {0.0, 1.0, 6.0}},
                                    {"target", {0.0, 0.0, 0.0}}}));
    EXPECT_EQ(header["interpolation"], "triangulated");
    EXPECT_EQ(header["polygon_numbers"].size(), header["polygons_seen"].get<std::size_t>());
}

TEST(StepsJson, TakesAnyFileName) {
    const Shell shell;
    shell.write("caf\xe9.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");  // Latin-1
    const Json json = Json::parse(output_of(shell, "scanlight steps --json caf\xe9.obj"));
    EXPECT_EQ(json["polygons"].size(), 1u);
}

TEST(StepsJson, InPerspectiveHasKeysWithoutBlanks) {
    const Json corner = steps_json("ngon:3 --perspective correct")[0]["corners"][0];
    for (const auto& [name, value] : corner["values"].items())
        EXPECT_EQ(name.find(' '), std::string::npos) << name;
}

TEST(StepsJson, HasThePolygonAskedFor) {
    const Json all = steps_json("cube --polygon all");
    ASSERT_EQ(all.size(), 6u);
    for (const auto* number : {"1", "4", "6"}) {
        const Json one = steps_json(std::string("cube --polygon ") + number);
        ASSERT_EQ(one.size(), 1u);
        EXPECT_EQ(one[0], all[std::stoul(number) - 1]);
        EXPECT_EQ(one[0]["polygon"].get<std::string::size_type>(), std::stoul(number));
    }
}

// ---- shadows at a pixel

TEST(StepsPixel, CountsTheSameFromTheEyeAndFromInfinity) {
    const Shell shell;
    int in_shadow = 0;
    for (int x = 0; x < 24; x += 2) {
        const Json lights = Json::parse(output_of(
            shell,
            "scanlight steps cube --floor --light point:-1,3,2 --light world:1,1,1 --json "
            "--pixel " +
                std::to_string(x) + ",12"));
        ASSERT_EQ(lights.size(), 2u);
        for (const Json& light : lights) {
            int all = 0;
            for (const Json& crossing : light["crossings"])
                all += crossing["enters"].get<int>();
            EXPECT_EQ(light["zpass"], light["zfail"]);
            EXPECT_EQ(light["in_shadow"].get<bool>(), light["zfail"] != 0);
            EXPECT_EQ(all, 0);  // a ray that begins outside ends outside
            in_shadow += light["in_shadow"].get<bool>() ? 1 : 0;
        }
    }
    EXPECT_GT(in_shadow, 2);
    EXPECT_LT(in_shadow, 22);
}

TEST(StepsPixel, IsListedFaceByFaceRoundTheSurface) {
    const std::string text =
        output_of(Shell(), "scanlight steps cube --floor --light point:-1,3,2 --pixel 12,8");
    EXPECT_NE(text.find("Pixel 12,8, light 1: "), std::string::npos) << text;
    for (const char* word : {"surface", "cap", "side", "z-pass", "z-fail"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in\n" << text;
}

TEST(StepsPixel, OutsideThePictureIsRefused) {
    for (const char* pixel : {"24,0", "0,16", "-1,3", "1", "1,2,3", "a,b"}) {
        const Outcome outcome = Shell().run(std::string("scanlight steps cube --pixel=") + pixel);
        EXPECT_EQ(outcome.status, 2) << pixel;
        EXPECT_NE(outcome.err.find("from 0,0 to 23,15"), std::string::npos) << outcome.err;
    }
}

}  // namespace
}  // namespace scanlight::apps
