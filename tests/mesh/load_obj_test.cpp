#include "mesh/load_obj.h"

#include <gtest/gtest.h>

#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {
namespace {

PolygonSoup obj(const std::string& text) {
    return read("obj", text);
}

std::vector<std::uint32_t> positions_of(const PolygonSoup& soup, std::size_t face) {
    std::vector<std::uint32_t> result;
    for (const PolygonSoup::Corner& corner : soup.face(face))
        result.push_back(corner.position);
    return result;
}

using Indices = std::vector<std::uint32_t>;

TEST(LoadObj, ReadsPositionsAndTheFace) {
    const PolygonSoup soup = obj(obj_triangle + "f 1 2 3\n");
    ASSERT_EQ(soup.positions.size(), 3u);
    EXPECT_EQ(soup.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(positions_of(soup, 0), (Indices{0, 1, 2}));
    EXPECT_TRUE(soup.materials.empty());
    EXPECT_TRUE(soup.face_material.empty());
    EXPECT_TRUE(soup.warnings.empty());
}

TEST(LoadObj, EveryFormOfCornerNamesTheSamePoint) {
    const std::string points = obj_triangle + "vt 0 0\nvt 1 0\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/2 2/1 3/1", "f 1//1 2//1 3//1", "f 1/2/1 2/1/1 3/1/1", "f -3 -2 -1",
          "f -3/-1/-1 2/1/1 -1/1/1", "f 1/ 2// 3", "f\t+1  2\t3 "}) {
        EXPECT_EQ(positions_of(obj(points + face), 0), (Indices{0, 1, 2})) << face;
    }
    const PolygonSoup::Corner corner = obj(points + "f -3/-1/-1 2/1/1 3/1/1").corners[0];
    EXPECT_EQ(corner.uv, 1u);
    EXPECT_EQ(corner.normal, 0u);
    EXPECT_EQ(obj(points + "f 1//1 2 3").corners[0].uv, PolygonSoup::none);
    EXPECT_EQ(obj(points + "f 1/1 2 3").corners[0].normal, PolygonSoup::none);
}

TEST(LoadObj, NegativeIndicesCountFromTheStatement) {
    const PolygonSoup soup = obj(obj_triangle + "f -3 -2 -1\nv 9 9 9\nf -3 -2 -1\n");
    EXPECT_EQ(positions_of(soup, 1), (Indices{1, 2, 3}));
}

TEST(LoadObj, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(positions_of(obj("f 1 2 3\n" + obj_triangle), 0), (Indices{0, 1, 2}));
}

TEST(LoadObj, PolygonsKeepAllTheirCorners) {
    std::string text;
    std::string face = "f";
    for (int i = 1; i <= 1000; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
        face += " " + std::to_string(i);
    }
    EXPECT_EQ(obj(text + face).face(0).size(), 1000u);
}

TEST(LoadObj, FacesWithFewCornersAreLeftForTheBuilderToCount) {
    const PolygonSoup soup = obj(obj_triangle + "f\nf 1\nf 1 2\nf 1 2 3\n");
    EXPECT_EQ(soup.face_count(), 4u);
    EXPECT_EQ(soup.face(0).size(), 0u);
    EXPECT_EQ(broken_promise(soup), "");
}

TEST(LoadObj, LineEndsBlanksCommentsAndContinuationsMeanTheSame) {
    const std::vector<std::string> writings{
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "\xEF\xBB\xBFv 0 0 0#c\n\n v\t1 0 0 # d\nv 0 1 0\n#\\\nf 1 2 3",
        "v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 2\\\r\n 3\n"};
    for (const std::string& writing : writings) {
        const PolygonSoup soup = obj(writing);
        EXPECT_EQ(soup.positions.size(), 3u) << writing;
        EXPECT_EQ(soup.positions[1], glm::vec3(1, 0, 0)) << writing;
        EXPECT_EQ(positions_of(soup, 0), (Indices{0, 1, 2})) << writing;
    }
}

TEST(LoadObj, VerticesWithoutColorAreWhiteAmongColoredOnes) {
    const PolygonSoup soup = obj("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1\nv 0 1 1 0 0 1 1\n");
    ASSERT_EQ(soup.colors.size(), 4u);
    EXPECT_EQ(soup.colors[0], glm::vec3(1));
    EXPECT_EQ(soup.colors[1], glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(soup.colors[2], glm::vec3(1));
    EXPECT_EQ(soup.colors[3], glm::vec3(0, 0, 1));
    EXPECT_TRUE(obj(obj_triangle).colors.empty());
}

TEST(LoadObj, FacesTakeTheMaterialInForceDefinedOrNot) {
    const PolygonSoup soup =
        obj(obj_triangle +
            "f 1 2 3\nusemtl red one\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl red one\nf 3 2 1");
    ASSERT_EQ(soup.materials.size(), 3u);
    EXPECT_EQ(soup.face_material, (Indices{0, 1, 2, 1}));
    EXPECT_EQ(soup.materials[0].name, "");
    EXPECT_EQ(soup.materials[1].name, "red one");
    ASSERT_EQ(soup.warnings.size(), 2u);
    EXPECT_EQ(soup.warnings[0],
              "file: material \"red one\" is not defined: a default one takes its place");
}

TEST(LoadObj, PassedOverStatementsAreCounted) {
    const PolygonSoup soup = obj(obj_triangle + "g a\no b\ns 1\nl 1 2\np 1\nhello\nf 1 2 3\n");
    ASSERT_EQ(soup.warnings.size(), 2u);
    EXPECT_EQ(soup.warnings[0],
              "file:7: line or point element \"l\" is passed over, the first of 2");
    EXPECT_EQ(soup.warnings[1],
              "file:9: unknown statement \"hello\" is passed over, the first of 1");
}

TEST(LoadObj, NothingToDrawIsAnEmptySoupAndAWarning) {
    EXPECT_EQ(obj("# nothing\n").face_count(), 0u);
    EXPECT_EQ(obj("# nothing\n").warnings.at(0), "file: has no faces");
}

TEST(LoadObj, BadFilesGetOneClearMessage) {
    const std::string t = obj_triangle;
    const std::string corner = " is not a corner: v, v/vt, v//vn or v/vt/vn";
    const std::vector<BadFile> files{
        {t + "f 1 2 99\n", "file:4: vertex index 99 is out of range: the file has 3 vertices"},
        {t + "f 1 2 3\nf 1 2 \\\n 4\n",
         "file:5: vertex index 4 is out of range: the file has 3 vertices"},
        {"f 1 2 3\nv 0 0 0\n", "file:1: vertex index 2 is out of range: the file has 1 vertex"},
        {t + "f 1 2 0\n", "file:4: vertex index 0: they count from 1"},
        {t + "f 1 2 -4\n",
         "file:4: vertex index -4 is out of range: the file has 3 vertices so far"},
        {t + "f 1 2 -2147483648\n",
         "file:4: vertex index -2147483648 is out of range: the file has 3 vertices so far"},
        {t + "f 1 2 4294967297\n",
         "file:4: vertex index 4294967297 is out of range: the file has 3 vertices so far"},
        {t + "f 1 2 9223372036854775808\n", "file:4: \"9223372036854775808\" is out of range"},
        {t + "f 1 2 /1\n", "file:4: \"/1\"" + corner},
        {t + "f 1 2 3.5\n", "file:4: \"3.5\"" + corner},
        {t + "f 1 2 x\n", "file:4: \"x\"" + corner},
        {t + "f 1/1 2/1 3/1\n",
         "file:4: texture coordinate index 1 is out of range: the file has 0 texture coordinates"},
        {t + "vt 0 0\nvn 0 0 1\nf 1 2 3/1/1/1\n", "file:6: \"3/1/1/1\"" + corner},
        {t + "f 1 2 -\n", "file:4: \"-\" is not an integer"},
        {t + "vt 0 0\nf 1/1 2/1 900000/1\n",
         "file:5: vertex index 900000 is out of range: the file has 3 vertices"},
        {t + "vt 0 0\nf 1/1 2/1 3/2\n",
         "file:5: texture coordinate index 2 is out of range: the file has 1 texture coordinate"},
        {t + "vt 0 0\nf 1/1 2/1 3/-2\n",
         "file:5: texture coordinate index -2 is out of range: the file has 1 texture coordinate "
         "so far"},
        {t + "f 1//1 2//1 3//1\n",
         "file:4: normal index 1 is out of range: the file has 0 normals"},
        {"v 0 0\n", "file:1: a number is missing"},
        {"\n\rv\r\n", "file:3: a number is missing"},
        {"v 0 0 zero\n", "file:1: \"zero\" is not a number"},
        {"v 0 0 0x10\n", "file:1: \"0x10\" is not a number"},
        {"v 0 0 1,5\n", "file:1: \"1,5\" is not a number"},
        {"v 0 0 +-1\n", "file:1: \"+-1\" is not a number"},
        {"v 0 0 0 1 1\n", "file:1: a vertex has 5 numbers: only 3, 4, 6 or 7 mean something"},
        {"v 0 0 0 1 1 1 1 1\n", "file:1: a vertex has more than 7 numbers"},
        {"vn 0 0\n", "file:1: a number is missing"},
        {"vn 0 0 1 1\n", "file:1: a normal has more than 3 numbers"},
        {"vt\n", "file:1: a number is missing"},
        {"vt 0 0 0 0\n", "file:1: a texture coordinate has more than 3 numbers"},
        {"usemtl\n", "file:1: usemtl has no name"},
        {"mtllib  \n", "file:1: mtllib has no name"},
        {std::string("v 0 0 0\nv 0 \0 0\n", 16), "file:2: a zero byte: this is not a text file"},
        {"v 0 0 " + std::string(100, '@') + "\n",
         "file:1: \"" + std::string(60, '@') + "...\" is not a number"},
        {"v 0 0 \x1b[31m\n", "file:1: \"?[31m\" is not a number"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("obj", file.bytes), file.message);
}

}  // namespace
}  // namespace scanlight::mesh
