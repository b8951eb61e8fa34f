#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

using Json = nlohmann::json;

Json info(const Shell& shell, const std::string& input) {
    const Outcome outcome = shell.run("scanlight info --json " + input);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
}

TEST(Info, OfAClosedBody) {
    const Json cube = info(Shell(), "cube");
    EXPECT_EQ(cube["faces"], 6);
    EXPECT_EQ(cube["drawn"], 6);
    EXPECT_EQ(cube["edges"], 12);
    EXPECT_EQ(cube["largest_polygon"], 4);
    EXPECT_EQ(cube["boundary_edges"], 0);
    EXPECT_EQ(cube["components"], 1);
    EXPECT_EQ(cube["closed"], true);
    EXPECT_EQ(cube["manifold"], true);
    EXPECT_EQ(cube["low"], Json({-1.0, -1.0, -1.0}));
    EXPECT_EQ(cube["high"], Json({1.0, 1.0, 1.0}));
    EXPECT_EQ(cube["warnings"], Json::array());
}

TEST(Info, OfAnOpenSheet) {
    const Json plane = info(Shell(), "plane:3");
    EXPECT_EQ(plane["faces"], 9);
    EXPECT_EQ(plane["edges"], 24);
    EXPECT_EQ(plane["boundary_edges"], 12);
    EXPECT_EQ(plane["closed"], false);
    EXPECT_EQ(plane["manifold"], true);
    EXPECT_EQ(plane["has_uvs"], true);
}

TEST(Info, CountsWhatWasDropped) {
    const Shell shell;
    shell.write("m.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 9 9 9\n"
                "f 1 2 3\nf 1 2 4\nf 1 1 2\n");
    const Json mesh = info(shell, "m.obj");
    EXPECT_EQ(mesh["faces"], 3);
    EXPECT_EQ(mesh["drawn"], 1);
    EXPECT_EQ(mesh["dropped"]["zero_area"], 1);
    EXPECT_EQ(mesh["dropped"]["fewer_than_3_corners"], 1);
    EXPECT_EQ(mesh["vertices"], 3);
    EXPECT_EQ(mesh["isolated_points"], 2);
}

TEST(Info, CountsWhatWasRepaired) {
    const Shell shell;
    // Three triangles at one edge.
    shell.write("book.off",
                "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n-1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
    const Json book = info(shell, "book.off");
    EXPECT_EQ(book["drawn"], 3);
    EXPECT_EQ(book["manifold"], false);
    EXPECT_EQ(book["closed"], false);
    EXPECT_GE(book["repaired"]["faces_given_corners_of_their_own"], 1);
    // Two triangles that touch in a point.
    shell.write("bow.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n");
    const Json bow = info(shell, "bow.off");
    EXPECT_EQ(bow["components"], 2);
    EXPECT_EQ(bow["manifold"], false);
    EXPECT_EQ(bow["repaired"]["points_doubled"], 1);
}

TEST(Info, NamesTheMaterials) {
    const Shell shell;
    shell.write("m.mtl", "newmtl brass\nKd 1 1 0\n");
    shell.write("m.obj", "mtllib m.mtl\nusemtl brass\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(info(shell, "m.obj")["materials"], Json::array({"brass"}));
}

TEST(Info, TakesNamesInAnyEncoding) {
    const Shell shell;
    shell.write("m.mtl", "newmtl caf\xe9\nKd 1 1 0\n");  // Latin-1
    shell.write("m.obj", "mtllib m.mtl\nusemtl caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(info(shell, "m.obj")["faces"], 1);
}

void expect_plain_keys(const Json& json) {
    for (const auto& [key, value] : json.items()) {
        EXPECT_EQ(key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789"), std::string::npos)
            << key;
        if (value.is_object()) expect_plain_keys(value);
    }
}

TEST(Info, AsJsonHasKeysThatProgramsLike) {
    expect_plain_keys(info(Shell(), "cube"));
}

TEST(Info, AsJsonHasTheShortestNumbersOfItsFloats) {
    const Shell shell;
    // 0.1, 0.7875 and 16777217 are no floats.
    shell.write("t.obj", "v 0.1 0 0\nv 0.7875 0 1e-9\nv 0.2 -3.4e38 16777217\nf 1 2 3\n");
    const std::string text = shell.run("scanlight info --json t.obj").out;
    const Json json = Json::parse(text);
    EXPECT_EQ(json["low"].dump(), "[0.1,-3.4e+38,0.0]") << text;
    EXPECT_EQ(json["high"].dump(), "[0.7875,0.0,16777216.0]") << text;
    EXPECT_NE(text.find(" 0.7875"), std::string::npos) << text;
    EXPECT_EQ(text.find("0.78750"), std::string::npos) << text;
}

TEST(Info, AsTextSaysTheSame) {
    const Shell shell;
    const Outcome outcome = shell.run("scanlight info cube");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("\nedges            12\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\nboundary edges   0\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\ndropped          zero area 0, fewer than 3 corners 0\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("\nclosed           yes\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\nwarnings         none\n"), std::string::npos) << outcome.out;
}

TEST(Info, ReadsStandardInput) {
    const Shell shell;
    const Outcome outcome = shell.run(
        "printf 'OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n' | scanlight info - --json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["faces"], 1);
}

TEST(Info, WritesMaterialsInOrder) {
    const Shell shell;
    shell.write("a.mtl",
                "newmtl oak\nTr 0.25\nKe 1\nmap_kd -s 2 old wood.png\nmap_Bump -bm 2 b.png\n");
    shell.write("m.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\n");
    const std::string expected =
        "newmtl oak\nKa 0.2 0.2 0.2\nKd 0.8 0.8 0.8\nKs 0 0 0\nKe 1 1 1\nTf 1 1 1\nNs 1\nNi 1\n"
        "d 0.75\nillum 2\nmap_Kd -s 2 1 1 old wood.png\nbump -bm 2 b.png\n";
    const Outcome printed = shell.run("scanlight info m.obj --mtl -");
    EXPECT_EQ(printed.status, 0) << printed.err;
    EXPECT_EQ(printed.out, expected);
    const Outcome saved = shell.run("scanlight info m.obj --mtl a.mtl");
    EXPECT_EQ(saved.status, 0) << saved.err;
    EXPECT_NE(saved.out.find("faces"), saved.out.npos);
    EXPECT_EQ(shell.read("a.mtl"), expected);
    EXPECT_EQ(shell.run("scanlight info m.obj --mtl -").out, expected);
    EXPECT_EQ(shell.run("scanlight info m.obj --mtl /no/such/folder.mtl").status, 2);
}

}  // namespace
}  // namespace scanlight::apps
