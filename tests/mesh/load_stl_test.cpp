#include "mesh/load_stl.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {
namespace {

const glm::vec3 a{0, 0, 0};
const glm::vec3 b{1, 0, 0};
const glm::vec3 c{0, 1, 0};
const glm::vec3 d{1, 1, 0};

std::string facet(const std::string& vertices) {
    return "facet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\n";
}

const std::string three = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

TEST(LoadStl, EqualCornersBecomeOnePoint) {
    const PolygonSoup soup =
        read("stl", binary_stl(2, stl_triangle(a, b, c) + stl_triangle(b, d, c)));
    EXPECT_EQ(soup.positions, (std::vector<glm::vec3>{a, b, c, d}));
    EXPECT_EQ(soup.face(1)[0].position, 1u);
    EXPECT_EQ(soup.face(1)[2].position, 2u);
}

TEST(LoadStl, MinusZeroIsZeroAndNothingElseIsNear) {
    const float tiny = std::numeric_limits<float>::denorm_min();
    const PolygonSoup soup = read(
        "stl", binary_stl(2, stl_triangle({-0.0f, 0, 0}, b, c) + stl_triangle(a, {tiny, 0, 0}, c)));
    EXPECT_EQ(soup.positions.size(), 4u);
    EXPECT_EQ(soup.face(0)[0].position, soup.face(1)[0].position);
    EXPECT_FALSE(std::signbit(soup.positions[0].x));
}

TEST(LoadStl, TextAndBinaryHoldTheSameMesh) {
    const PolygonSoup text = read("stl", "solid a\n" + facet(three) + "endsolid a\n");
    const PolygonSoup binary = read("stl", binary_stl(1, stl_triangle(a, b, c)));
    EXPECT_EQ(text.positions, binary.positions);
    EXPECT_EQ(text.face_begin, binary.face_begin);
    EXPECT_TRUE(text.warnings.empty());
}

TEST(LoadStl, ABinaryFileMayBeginWithSolid) {
    const std::string triangle = stl_triangle(a, b, c);
    EXPECT_EQ(read("stl", binary_stl(1, triangle, "solid facet normal")).face_count(), 1u);
    EXPECT_EQ(read("stl", binary_stl(1, triangle, "solid" + std::string(75, ' '))).face_count(),
              1u);
}

TEST(LoadStl, TextMayHoldSeveralSolidsInAnyCase) {
    const std::string loud =
        "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
        "VERTEX 0 0 1\nENDLOOP\nENDFACET\nENDSOLID\n";
    const PolygonSoup soup =
        read("stl", "solid outer loop\n" + facet(three) + "endsolid x y\n\n" + loud);
    EXPECT_EQ(soup.face_count(), 2u);
    EXPECT_EQ(soup.positions.size(), 4u);
}

TEST(LoadStl, NormalsOfSliversMayBeAnything) {
    std::string text = "solid\n" + facet(three) + "endsolid\n";
    text.replace(text.find("0 0 1"), 5, "nan -nan(ind) 1.#INF");
    EXPECT_EQ(read("stl", text).face_count(), 1u);
}

TEST(LoadStl, ATailTooShortForATriangleIsAWarning) {
    const std::string bytes = binary_stl(1, stl_triangle(a, b, c));
    EXPECT_EQ(read("stl", bytes + "zz").warnings.at(0),
              "file: 2 bytes after the last triangle passed over");
    EXPECT_EQ(read("stl", bytes + std::string(49, 'z')).face_count(), 1u);
    EXPECT_NE(read_error("stl", bytes + std::string(50, 'z')), "");
}

TEST(LoadStl, BadFilesGetOneClearMessage) {
    const float inf = std::numeric_limits<float>::infinity();
    const std::string triangle = stl_triangle(a, b, c);
    const std::string two = triangle + triangle;
    const std::string whole = facet(three);
    const auto length = [](const std::string& declared, const std::string& held) {
        return "file: byte 80: " + declared + " declared, but the file's length is that of " + held;
    };
    const std::vector<BadFile> files{
        {binary_stl(4000000000u, two), length("4000000000 triangles are", "2")},
        {binary_stl(3, two), length("3 triangles are", "2")},
        {binary_stl(1, two), length("1 triangle is", "2")},
        {binary_stl(0, two), length("0 triangles are", "2")},
        {binary_stl(2, two.substr(0, 99)), length("2 triangles are", "1")},
        {binary_stl(1, ""), length("1 triangle is", "0")},
        {binary_stl(0xffffffffu, ""), length("4294967295 triangles are", "0")},
        {binary_stl(3, two, "solid"), length("3 triangles are", "2")},
        {"garbage", "file: byte 7: ends inside the header of a binary STL file"},
        {std::string(83, 'x'), "file: byte 83: ends inside the header of a binary STL file"},
        {binary_stl(1, stl_triangle({inf, 0, 0}, b, c)), "file: byte 96: not a finite number"},
        {binary_stl(1, stl_triangle({0, -inf, 0}, b, c)), "file: byte 100: not a finite number"},
        {binary_stl(1, stl_triangle(a, {0, 0, NAN}, c)), "file: byte 116: not a finite number"},
        {binary_stl(2, triangle + stl_triangle(a, b, {NAN, 0, 0})),
         "file: byte 170: not a finite number"},
        {"solid", "file:1: ends before facet"},
        {"solid a\n", "file:2: ends before facet"},
        {"solid\nvertex 0 0 0\n", "file:2: \"vertex\" stands where \"facet\" must"},
        {"solid\nfacet\n", "file:3: ends before normal"},
        {"solid\nfacet 0 0 1\n", "file:2: \"0\" stands where \"normal\" must"},
        {"solid\nfacet normal 0 0\n", "file:3: ends before the facet's normal"},
        {"solid\nfacet normal 0 0 1\nloop\n", "file:3: \"loop\" stands where \"outer\" must"},
        {"solid\nfacet normal 0 0 1\nouter\nvertex\n",
         "file:4: \"vertex\" stands where \"loop\" must"},
        {"solid\n" + facet("vertex 0 0\n"), "file:4: a number is missing"},
        {"solid\n" + facet("vertex 0 0 nan\n"), "file:4: \"nan\" is not a finite number"},
        {"solid\n" + facet("vertex 0 0 1e39\n"), "file:4: \"1e39\" is out of range"},
        {"solid\n" + facet("vertex 0 0 0 0\n"), "file:4: \"0\" stands where \"vertex\" must"},
        {"solid\n" + facet("point 0 0 0\n"), "file:4: \"point\" stands where \"vertex\" must"},
        {"solid\nfacet normal 0 0 1\nouter loop\n" + three, "file:7: ends before vertex"},
        {"solid\nfacet normal 0 0 1\nouter loop\n" + three + "endloop\n",
         "file:8: ends before endfacet"},
        {"solid\n" + whole, "file:9: ends before facet"},
        {"solid\n" + whole + "endsolid\n" + whole,
         "file:10: \"facet\" stands where \"solid\" must"},
        {"solid\n" + whole + "end solid\n", "file:9: \"end\" stands where \"facet\" must"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("stl", file.bytes), file.message);
}

}  // namespace
}  // namespace scanlight::mesh
