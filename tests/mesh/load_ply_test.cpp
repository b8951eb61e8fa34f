#include "mesh/load_ply.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/palette.h"
#include "mesh/srgb.h"
#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {
namespace {

PolygonSoup ply(const std::string& declarations, const std::string& body) {
    return read("ply", text_ply(declarations, body));
}

void expect_triangle(const PolygonSoup& soup, const std::string& what) {
    ASSERT_EQ(soup.positions.size(), 3u) << what;
    EXPECT_EQ(soup.positions[1], glm::vec3(1, 0, 0)) << what;
    EXPECT_EQ(soup.positions[2], glm::vec3(0, 1, 0)) << what;
    ASSERT_EQ(soup.face_count(), 1u) << what;
    ASSERT_EQ(soup.face(0).size(), 3u) << what;
    EXPECT_EQ(soup.face(0)[2].position, 2u) << what;
    EXPECT_EQ(broken_promise(soup), "") << what;
}

/// A number as PLY's `type` writes it in a binary file.
std::string binary(const std::string& type, double value, bool big_endian) {
    const std::string bytes = type == "char"    ? bytes_of_number(static_cast<std::int8_t>(value))
                              : type == "uchar" ? bytes_of_number(static_cast<std::uint8_t>(value))
                              : type == "short" ? bytes_of_number(static_cast<std::int16_t>(value))
                              : type == "ushort"
                                  ? bytes_of_number(static_cast<std::uint16_t>(value))
                              : type == "int"   ? bytes_of_number(static_cast<std::int32_t>(value))
                              : type == "uint"  ? bytes_of_number(static_cast<std::uint32_t>(value))
                              : type == "float" ? bytes_of_number(static_cast<float>(value))
                                                : bytes_of_number(value);
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binary_triangle(const std::string& coordinate, const std::string& count,
                            const std::string& index, bool big_endian) {
    std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                        "_endian 1.0\nelement vertex 3\n";
    for (const char* axis : {"x", "y", "z"})
        bytes += "property " + coordinate + " " + axis + "\n";
    bytes += "element face 1\nproperty list " + count + " " + index + " vertex_index\nend_header\n";
    for (const double value : {0, 0, 0, 1, 0, 0, 0, 1, 0})
        bytes += binary(coordinate, value, big_endian);
    bytes += binary(count, 3, big_endian);
    for (const double value : {0, 1, 2})
        bytes += binary(index, value, big_endian);
    return bytes;
}

TEST(LoadPly, AnyScalarTypesInAnyEncoding) {
    const std::vector<std::string> types{"char", "uchar", "short", "ushort",
                                         "int",  "uint",  "float", "double"};
    for (const std::string& coordinate : types) {
        for (const std::string& index : types) {
            for (const bool big_endian : {false, true}) {
                const std::string count = index == "float" || index == "double" ? "uchar" : index;
                expect_triangle(read("ply", binary_triangle(coordinate, count, index, big_endian)),
                                coordinate + " " + index);
            }
            expect_triangle(
                ply("element vertex 3\nproperty " + coordinate + " x\nproperty " + coordinate +
                        " y\nproperty " + coordinate + " z\nelement face 1\n" +
                        "property list uchar " + index + " vertex_indices\n",
                    ply_triangle),
                coordinate + " " + index);
        }
    }
}

TEST(LoadPly, ElementsMayComeInAnyOrder) {
    expect_triangle(ply(ply_faces + ply_points, "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n"), "faces first");
}

TEST(LoadPly, UnknownElementsAndPropertiesArePassedOver) {
    const std::string declarations =
        "comment c\nobj_info end_header x\nelement odd 2\nproperty list uchar float l\nproperty "
        "int i\n"
        "element vertex 3\nproperty list uchar int w\nproperty float x\nproperty float confidence\n"
        "property float y\nproperty float z\nelement none 5\n" +
        ply_faces + "property list uchar short k\n";
    const std::string body = "2 0.5 nan 7\n0 7\n1 9 0 5 0 0\n0 1 5 0 0\n0 0 5 1 0\n3 0 1 2 1 9\n";
    const PolygonSoup soup = ply(declarations, body);
    expect_triangle(soup, "unknown things");
    EXPECT_EQ(soup.warnings,
              (std::vector<std::string>{"file: element \"odd\" (2 records) is passed over"}));
}

TEST(LoadPly, IndicesInAVertexAreNoFacesCorners) {
    expect_triangle(ply("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        "property list uchar int vertex_indices\n"
                        "element face 1\nproperty list uchar int vertex_indices\n",
                        "0 0 0 1 2\n1 0 0 0\n0 1 0 2 1 1\n3 0 1 2\n"),
                    "a list of indices at each vertex");
}

TEST(LoadPly, LineEndsMayBeAnyInText) {
    const std::string text = text_ply(ply_points + ply_faces, ply_triangle);
    std::string cr = text;
    std::ranges::replace(cr, '\n', '\r');
    std::string crlf;
    for (const char c : text)
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
    expect_triangle(read("ply", cr), "CR");
    expect_triangle(read("ply", crlf), "CRLF");
}

TEST(LoadPly, BinaryDataMayStartWithALineFeed) {
    const std::string declarations =
        "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
    std::string header = "ply\nformat binary_little_endian 1.0\n" + declarations + "end_header\n";
    EXPECT_EQ(read("ply", header + "\n\r\n").positions.at(0), glm::vec3(10, 13, 10));
    std::ranges::replace(header, '\n', '\r');
    EXPECT_EQ(read("ply", header + "\n\r\n").positions.at(0), glm::vec3(10, 13, 10));
}

TEST(LoadPly, VerticesBringNormalsAndTextureCoordinates) {
    for (const char* names : {"u v", "s t", "texture_u texture_v", "texture_s texture_t"}) {
        const std::string both = names;
        const std::size_t blank = both.find(' ');
        const PolygonSoup soup =
            ply("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property float nx\nproperty float ny\nproperty float nz\nproperty float " +
                    both.substr(0, blank) + "\nproperty float " + both.substr(blank + 1) + "\n" +
                    ply_faces,
                "0 0 0 0 0 1 0 0\n1 0 0 0 0 2 1 0\n0 1 0 0 0 3 0 1\n3 0 1 2\n");
        expect_triangle(soup, names);
        EXPECT_EQ(soup.normals.at(2), glm::vec3(0, 0, 3));
        EXPECT_EQ(soup.uvs.at(2), glm::vec2(0, 1));
        EXPECT_EQ(soup.face(0)[2].normal, 2u);
        EXPECT_EQ(soup.face(0)[2].uv, 2u);
    }
}

TEST(LoadPly, IntegerColorsAreSrgbAndFractionsLinear) {
    const auto vertex = [](const std::string& type) {
        return "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty " +
               type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
    };
    EXPECT_EQ(ply(vertex("uchar"), "0 0 0 0 128 255\n").colors.at(0),
              glm::vec3(0, linear_from_srgb(128), 1));
    EXPECT_EQ(ply(vertex("int"), "0 0 0 1 1 1\n").colors.at(0), glm::vec3(linear_from_srgb(1)));
    EXPECT_EQ(ply(vertex("float"), "0 0 0 0 0.5 1\n").colors.at(0), glm::vec3(0, 0.5f, 1));
}

TEST(LoadPly, FaceColorsBecomeMaterialsAsScalarsOrLists) {
    const std::string faces = "element face 3\nproperty list uchar int vertex_indices\n";
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    const PolygonSoup scalars =
        ply(ply_points + faces + "property uchar red\nproperty uchar green\nproperty uchar blue\n",
            points + "3 0 1 2 255 0 0\n3 0 1 2 0 255 0\n3 0 1 2 255 0 0\n");
    EXPECT_EQ(scalars.face_material, (std::vector<std::uint32_t>{1, 2, 1}));
    EXPECT_EQ(scalars.materials.at(2).diffuse, glm::vec3(0, 1, 0));
    const PolygonSoup lists = ply(ply_points + faces + "property list uchar float color\n",
                                  points + "3 0 1 2 3 1 0 0\n3 0 1 2 4 0 1 0 0.5\n3 0 1 2 2 0 0\n");
    EXPECT_EQ(lists.face_material, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(lists.materials.at(1).diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(lists.materials.at(3).diffuse, glm::vec3(1));
    EXPECT_EQ(lists.warnings.size(), 1u);
}

TEST(LoadPly, DataAfterTheLastRecordIsAWarning) {
    EXPECT_EQ(ply(ply_points + ply_faces, ply_triangle + "3 0 1 2\n").warnings.at(0),
              "file: 8 bytes after the last record passed over");
    EXPECT_TRUE(ply(ply_points + ply_faces, ply_triangle + "\n \n").warnings.empty());
}

TEST(LoadPly, BadFilesGetOneClearMessage) {
    const auto bad = [](const std::string& declarations, const std::string& body = {}) {
        return text_ply(declarations, body);
    };
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string both = ply_points + ply_faces;
    const std::string header_only = "ply\nformat ascii 1.0\nelement vertex 3\n";
    const std::vector<BadFile> files{
        {"ply", "file:1: the header has no end_header"},
        {"plyx\n", "file:1: a PLY file starts with \"ply\""},
        {header_only, "file:4: the header has no end_header"},
        {"ply\nend_header\n", "file:3: the header has no format line"},
        {"ply\nformat text 1.0\nend_header\n", "file:2: \"text\" is not a PLY format"},
        {"ply\nformat ascii 2.0\nend_header\n", "file:2: only version 1.0 of PLY is known"},
        {bad("property float x\n"), "file:3: a property before the first element"},
        {bad("element\n"), "file:3: the element has no name"},
        {bad("element vertex\n"), "file:3: a number is missing"},
        {bad("element vertex -1\n"), "file:3: element \"vertex\" has a negative count"},
        {bad("element vertex 1e3\n"), "file:3: \"1e3\" is not an integer"},
        {bad("element vertex 18446744073709551617\n"),
         "file:3: \"18446744073709551617\" is out of range"},
        {bad("element vertex 1\nelement vertex 1\n"),
         "file:4: element \"vertex\" is declared twice"},
        {bad("element vertex 1\nproperty float x\nproperty float x\n"),
         "file:5: property \"x\" is declared twice"},
        {bad("element vertex 1\nproperty real x\n"), "file:4: \"real\" is not a PLY type"},
        {bad("element vertex 1\nproperty float\n"), "file:4: the property has no name"},
        {bad("element face 1\nproperty list float int vertex_indices\n"),
         "file:4: the length of list \"vertex_indices\" is not an integer type"},
        {bad("element face 1\nproperty list uchar\n"), "file:4: \"\" is not a PLY type"},
        {bad("vertices 3\n"), "file:3: \"vertices\" is not a header statement"},
        {bad("element vertex 0\nproperty float x\nproperty float y\n"),
         "file:7: element \"vertex\" lacks x, y or z"},
        {bad("element vertex 4000000000\n"), "file:5: element \"vertex\" lacks x, y or z"},
        {bad("element face 4000000000\n"),
         "file:5: element \"face\" has no list vertex_indices or vertex_index"},
        {bad(both, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "file:11: a number is missing"},
        {bad(both, "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"),
         "file:11: more numbers on the line than the header declares"},
        {bad(both, "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "file:11: \"x\" is not a number"},
        {bad(both, "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "file:11: \"nan\" is not a finite number"},
        {bad(both, "0 0 0\n1 1e39 0\n0 1 0\n3 0 1 2\n"), "file:11: a number is out of range"},
        {bad(both, points + "3 0 1 3\n"),
         "file:13: vertex index 3 is out of range: the file has 3 vertices"},
        {bad(both, points + "3 0 1 -1\n"),
         "file:13: vertex index -1 is out of range: the file has 3 vertices"},
        {bad(both, points + "3 0 1 1.5\n"),
         "file:13: \"1.5\" does not fit the type of its property"},
        {bad(both, points + "3 0 1 3000000000\n"),
         "file:13: \"3000000000\" does not fit the type of its property"},
        {bad(both, points + "-1 0 1 2\n"), "file:13: \"-1\" does not fit the type of its property"},
        {bad(both, points + "400000000 0 1 2\n"),
         "file:13: \"400000000\" does not fit the type of its property"},
        {bad(both, points + "3 0 1\n"), "file:13: a number is missing"},
        {bad(both, points),
         "file:13: element \"face\" declares 1 record, but only 0 bytes are left"},
        {bad(ply_points + "element face 1\nproperty list char int vertex_indices\n",
             points + "-1 0 1 2\n"),
         "file:13: a list has a negative length"},
        {bad(ply_points + "element face 1\nproperty list uchar float vertex_indices\n",
             points + "3 0 1 0.5\n"),
         "file:13: a vertex index is not an integer: the file has 3 vertices"},
        {bad(ply_points + "element face 1\nproperty list int int vertex_indices\n",
             points + "400000000 0 1 2\n"),
         "file:13: a list of 400000000 values is declared, but only 7 bytes are left"},
        {bad("element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty int "
             "red\n",
             "0 0 0 256\n"),
         "file:9: a color is not from 0 to 255"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("ply", file.bytes), file.message);
}

TEST(LoadPly, BadBinaryFilesNameTheByte) {
    const std::string whole = binary_triangle("float", "uchar", "int", false);
    const std::size_t body = whole.find("end_header\n") + 11;
    const auto with = [&](std::size_t offset, const std::string& bytes) {
        return std::string(whole).replace(body + offset, bytes.size(), bytes);
    };
    const auto at = [&](std::size_t offset) {
        return "file: byte " + std::to_string(body + offset) + ": ";
    };
    EXPECT_EQ(read_error("ply", with(4, bytes_of_number(NAN))), at(8) + "not a finite number");
    EXPECT_EQ(read_error("ply", with(45, bytes_of_number(9))),
              at(49) + "vertex index 9 is out of range: the file has 3 vertices");
    EXPECT_EQ(read_error("ply", with(36, "\xff")),
              at(37) + "a list of 255 values is declared, but only 12 bytes are left");
    EXPECT_EQ(read_error("ply", whole.substr(0, body + 35)),
              at(0) + "element \"vertex\" declares 3 records, but only 35 bytes are left");
}

TEST(Palette, PastItsBoundFacesTakeTheDefault) {
    Palette palette;
    for (std::size_t i = 0; i < Palette::max_colors; ++i) {
        ASSERT_EQ(palette.index_of({static_cast<float>(i), 0, 0}), i + 1);
    }
    EXPECT_EQ(palette.index_of({-1, 0, 0}), 0u);
    EXPECT_EQ(palette.index_of({5, 0, 0}), 6u);
    PolygonSoup soup;
    std::move(palette).give_to(soup);
    EXPECT_EQ(soup.warnings.size(), 1u);
    EXPECT_EQ(soup.materials.size(), Palette::max_colors + 1);
}

TEST(Srgb, DecodesAsTheStandardSays) {
    EXPECT_EQ(linear_from_srgb(0), 0.0f);
    EXPECT_EQ(linear_from_srgb(255), 1.0f);
    for (int i = 0; i < 256; ++i) {
        const double value = i / 255.0;
        const double linear =
            value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(linear_from_srgb(static_cast<std::uint8_t>(i)), linear, 6e-8) << i;
    }
}

}  // namespace
}  // namespace scanlight::mesh
