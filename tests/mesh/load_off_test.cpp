#include "mesh/load_off.h"

#include <gtest/gtest.h>

#include "mesh/srgb.h"
#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {
namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n";

TEST(LoadOff, EveryWayToStartMeansTheSame) {
    const std::string body = points + "3 0 1 2\n";
    for (const std::string start :
         {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF3 1 0\n", "3 1 0\n", "OFF\n3 1\n",
          "# c\n\nOFF # d\n# e\n3 # f\n1\n", "OFF\r\n3 1 0\r\n", "OFF\r3 1 7\r"}) {
        const PolygonSoup soup = read("off", start + body);
        ASSERT_EQ(soup.positions.size(), 3u) << start;
        EXPECT_EQ(soup.positions[1], glm::vec3(1, 0, 0)) << start;
        EXPECT_EQ(soup.face(0).size(), 3u) << start;
        EXPECT_TRUE(soup.materials.empty()) << start;
    }
}

TEST(LoadOff, CommentsMayStandAnywhere) {
    const PolygonSoup soup =
        read("off", "OFF\n3 1 0\n#\n0 0 0 # a\n\n# b\n1 0 0\n0 1 0\n# c\n3 0 1 2 # d\n# e\n");
    EXPECT_EQ(soup.face_count(), 1u);
    EXPECT_TRUE(soup.warnings.empty());
}

TEST(LoadOff, PrefixesSayWhatAVertexHolds) {
    const std::string normal = " 0 0 1";
    const std::string color = " 255 0 255";
    const std::string uv = " 0.5 0.25";
    for (const bool n : {false, true}) {
        for (const bool c : {false, true}) {
            for (const bool st : {false, true}) {
                const std::string line =
                    "1 2 3" + (n ? normal : "") + (c ? color : "") + (st ? uv : "");
                const std::string keyword =
                    std::string(st ? "ST" : "") + (c ? "C" : "") + (n ? "N" : "") + "OFF";
                const PolygonSoup soup = read("off", keyword + "\n1 1 0\n" + line + "\n1 0\n");
                EXPECT_EQ(soup.positions.at(0), glm::vec3(1, 2, 3)) << keyword;
                ASSERT_EQ(soup.normals.size(), n ? 1u : 0u) << keyword;
                if (n) {
                    EXPECT_EQ(soup.normals[0], glm::vec3(0, 0, 1)) << keyword;
                }
                ASSERT_EQ(soup.colors.size(), c ? 1u : 0u) << keyword;
                if (c) {
                    EXPECT_EQ(soup.colors[0], glm::vec3(1, 0, 1)) << keyword;
                }
                ASSERT_EQ(soup.uvs.size(), st ? 1u : 0u) << keyword;
                if (st) {
                    EXPECT_EQ(soup.uvs[0], glm::vec2(0.5f, 0.25f)) << keyword;
                }
                EXPECT_EQ(broken_promise(soup), "") << keyword;
            }
        }
    }
}

TEST(LoadOff, ColorsAreSrgbAsIntegersAndLinearAsFractions) {
    const PolygonSoup soup =
        read("off", "COFF\n3 0 0\n0 0 0 128 0 255\n0 0 0 0.5 0 1 1\n0 0 0 1 1 1 1\n");
    EXPECT_EQ(soup.colors.at(0), glm::vec3(linear_from_srgb(128), 0, 1));
    EXPECT_EQ(soup.colors.at(1), glm::vec3(0.5f, 0, 1));
    EXPECT_EQ(soup.colors.at(2), glm::vec3(linear_from_srgb(1)));
}

TEST(LoadOff, FaceColorsBecomeMaterialsOnePerDistinctColor) {
    const PolygonSoup soup = read("off", "OFF\n3 5 0\n" + points +
                                             "3 0 1 2 255 0 0\n3 0 1 2\n3 0 1 2 1.0 0 0\n"
                                             "3 0 1 2 0 1.0 0 0.5\n3 0 1 2 7\n");
    ASSERT_EQ(soup.materials.size(), 3u);
    EXPECT_EQ(soup.face_material, (std::vector<std::uint32_t>{1, 0, 1, 2, 0}));
    EXPECT_EQ(soup.materials[1].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(soup.materials[0].diffuse, Material{}.diffuse);
    EXPECT_EQ(soup.warnings.at(0),
              "file: 1 face has an index into a color map, which is passed over");
}

TEST(LoadOff, TextAfterTheLastFaceIsAWarning) {
    EXPECT_EQ(read("off", "OFF\n3 1 0\n" + points + "3 0 1 2\n3 0 1 2\n").warnings.at(0),
              "file: the text after the last face is passed over");
}

TEST(LoadOff, BadFilesGetOneClearMessage) {
    const std::string head = "OFF\n3 1 0\n";
    const std::vector<BadFile> files{
        {"OFF", "file:1: the count of vertices is missing"},
        {"OFF\n", "file:2: the count of vertices is missing"},
        {"OFF\n3\n", "file:3: the count of faces is missing"},
        {"OFF\nthree 1 0\n", "file:2: \"three\" is not an integer"},
        {"OFF\n3.5 1 0\n", "file:2: \"3.5\" is not an integer"},
        {"OFF\n-3 1 0\n", "file:2: a negative count of vertices"},
        {"OFF\n3 -1 0\n", "file:2: a negative count of faces"},
        {"OFF\n3 1 e\n", "file:2: \"e\" is not an integer"},
        {"OFF\n99999999999999999999 1 0\n", "file:2: \"99999999999999999999\" is out of range"},
        {"OFF BINARY\n", "file:1: binary OFF is not read here: convert it to text"},
        {"4OFF\n1 0 0\n0 0 0 1\n", "file:1: OFF with prefix \"4\" is not read here"},
        {"nOFF\n3\n1 0 0\n", "file:1: OFF with prefix \"n\" is not read here"},
        {"C4OFF\n1 0 0\n", "file:1: OFF with prefix \"4\" is not read here"},
        {head + "0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "file:5: a vertex has 2 numbers, not 3"},
        {head + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n", "file:4: a vertex has 4 numbers, not 3"},
        {head + "0 0 0\n1 0 0 0 0 0 0 0 0 0 0 0 0\n0 1 0\n3 0 1 2\n",
         "file:4: a vertex has more than 12 numbers, not 3"},
        {"COFF\n3 1 0\n" + points + "3 0 1 2" + std::string(9, ' '),
         "file:3: a vertex has 3 numbers, not 6 or 7"},
        {"COFF\n1 0 0\n0 0 0 0 0 256\n", "file:3: a color is not from 0 to 255"},
        {"COFF\n1 0 0\n0 0 0 0 0 -1\n", "file:3: a color is not from 0 to 255"},
        {"NOFF\n1 0 0\n0 0 0 0 0 \n", "file:3: a vertex has 5 numbers, not 6"},
        {head + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "file:4: \"nan\" is not a finite number"},
        {head + "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "file:4: \"x\" is not a number"},
        {head + points + "3 0 1 99\n",
         "file:6: vertex index 99 is out of range: the file has 3 vertices"},
        {head + points + "3 0 1 3\n",
         "file:6: vertex index 3 is out of range: the file has 3 vertices"},
        {head + points + "3 0 1 -1\n",
         "file:6: vertex index -1 is out of range: the file has 3 vertices"},
        {head + points + "3 0 1\n", "file:6: a number is missing"},
        {head + points + "3 0 1 2.5\n", "file:6: \"2.5\" is not an integer"},
        {head + points + "-3 0 1 2\n", "file:6: a face has a negative number of corners"},
        {head + points + "400000000 0 1 2\n",
         "file:6: 400000000 corners are declared, but only 7 bytes are left"},
        {head + points + "3 0 1 2 255 0\n", "file:6: a face's color has 1, 3 or 4 numbers"},
        {head + points + "3 0 1 2 1 1 1 1 1\n", "file:6: a face's color has 1, 3 or 4 numbers"},
        {head + points + "3 0 1 2 256 0 0\n", "file:6: a color is not from 0 to 255"},
        {head + points + "3 0 1 2 red\n", "file:6: \"red\" is not a number"},
        {"OFF\n3 2 0\n" + points + "3 0 1 2\n", "file:7: a number is missing"},
        {std::string("OFF\0\n", 5), "file:1: a zero byte: this is not a text file"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("off", file.bytes), file.message);
}

}  // namespace
}  // namespace scanlight::mesh
