// Laws of the readers on seeded random meshes, and their agreement with tinyobjloader.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <locale>
#include <random>
#include <set>
#include <sstream>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "mesh/load_number.h"
#include "mesh/weld.h"
#include "tests/mesh/reading.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {
namespace {

using Random = std::mt19937;

std::uint32_t below(Random& random, std::uint32_t bound) {
    return static_cast<std::uint32_t>(random() % bound);
}

/// Any finite float, small and large alike.
float any_float(Random& random) {
    for (;;) {
        const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isfinite(value)) return value;
    }
}

/// Any points, any polygons over them.
PolygonSoup random_soup(Random& random) {
    PolygonSoup soup;
    const std::uint32_t points = 1 + below(random, 30);
    for (std::uint32_t i = 0; i < points; ++i) {
        soup.positions.push_back({any_float(random), any_float(random), any_float(random)});
    }
    for (std::uint32_t f = below(random, 20); f > 0; --f) {
        for (std::uint32_t n = below(random, 9); n > 0; --n)
            soup.corners.push_back({below(random, points)});
        soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    return soup;
}

std::string shortest(float value) {
    char digits[64];
    return {digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr};
}

std::string line_of(const glm::vec3& v) {
    return shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n";
}

std::string face_lines(const PolygonSoup& soup, bool counted, std::uint32_t first) {
    std::string text;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        text += counted ? std::to_string(soup.face(f).size()) : "f";
        for (const auto& corner : soup.face(f))
            text += " " + std::to_string(corner.position + first);
        text += "\n";
    }
    return text;
}

std::string as_obj(const PolygonSoup& soup) {
    std::string text;
    for (const glm::vec3& position : soup.positions)
        text += "v " + line_of(position);
    return text + face_lines(soup, false, 1);
}

std::string counted_body(const PolygonSoup& soup) {
    std::string text;
    for (const glm::vec3& position : soup.positions)
        text += line_of(position);
    return text + face_lines(soup, true, 0);
}

std::string as_off(const PolygonSoup& soup) {
    return "OFF\n" + std::to_string(soup.positions.size()) + " " +
           std::to_string(soup.face_count()) + " 0\n" + counted_body(soup);
}

std::string ply_header(const PolygonSoup& soup, const std::string& encoding) {
    return "ply\nformat " + encoding + " 1.0\nelement vertex " +
           std::to_string(soup.positions.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(soup.face_count()) +
           "\nproperty list uchar uint vertex_indices\nend_header\n";
}

template <std::endian order, class Number>
std::string ordered(Number number) {
    return bytes_of_number(load_number<Number, order>(bytes_of_number(number).data()));
}

template <std::endian order>
std::string as_binary_ply(const PolygonSoup& soup) {
    std::string bytes =
        ply_header(soup, order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
    for (const glm::vec3& p : soup.positions) {
        bytes += ordered<order>(p.x) + ordered<order>(p.y) + ordered<order>(p.z);
    }
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        bytes += static_cast<char>(soup.face(f).size());
        for (const auto& corner : soup.face(f))
            bytes += ordered<order>(corner.position);
    }
    return bytes;
}

void expect_same(const PolygonSoup& soup, const PolygonSoup& again) {
    ASSERT_EQ(soup.positions.size(), again.positions.size());
    EXPECT_EQ(std::memcmp(soup.positions.data(), again.positions.data(),
                          soup.positions.size() * sizeof(glm::vec3)),
              0);
    EXPECT_EQ(soup.face_begin, again.face_begin);
    EXPECT_TRUE(std::ranges::equal(soup.corners, again.corners, {}, &PolygonSoup::Corner::position,
                                   &PolygonSoup::Corner::position));
}

TEST(LoadLaws, WhatIsWrittenExactlyIsReadExactly) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const PolygonSoup soup = random_soup(random);
        expect_same(soup, read("obj", as_obj(soup)));
        expect_same(soup, read("off", as_off(soup)));
        expect_same(soup, read("ply", ply_header(soup, "ascii") + counted_body(soup)));
        expect_same(soup, read("ply", as_binary_ply<std::endian::little>(soup)));
        expect_same(soup, read("ply", as_binary_ply<std::endian::big>(soup)));
        if (HasFailure()) break;
    }
}

/// Writes 1,234.5 as "1.234,5".
struct CommaForPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(LoadLaws, TheLocaleHasNoSay) {
    Random random(2);
    const PolygonSoup soup = random_soup(random);
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaForPoint));
    std::ostringstream written;
    written << 1234.5;
    expect_same(soup, read("obj", as_obj(soup)));
    expect_same(soup, read("ply", ply_header(soup, "ascii") + counted_body(soup)));
    expect_same(soup, read("off", as_off(soup)));
    const std::string error = read_error("off", "OFF\n1000000 0 0\n");
    std::locale::global(before);
    EXPECT_EQ(written.str(), "1.234,5");  // the locale was in force
    EXPECT_EQ(error, "file:2: 1000000 vertices are declared, but only 1 byte is left");
}

TEST(LoadLaws, WeldingMapsEachPointToItselfAndEqualOnesToOne) {
    Random random(3);
    Welder welder;
    std::vector<glm::vec3> points;
    std::vector<std::uint32_t> indices;
    std::set<std::array<float, 3>> distinct;
    for (int i = 0; i < 20000; ++i) {
        const auto coordinate = [&] { return static_cast<float>(below(random, 20)); };
        const glm::vec3 point{coordinate(), coordinate(), coordinate()};
        points.push_back(point);
        distinct.insert({point.x, point.y, point.z});
        indices.push_back(welder.index_of(point));
    }
    const std::vector<glm::vec3> welded = std::move(welder).take();
    EXPECT_EQ(welded.size(), distinct.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(welded[indices[i]], points[i]);
}

/// A number both readers must read alike: an eighth more or less.
std::string eighths(Random& random) {
    return shortest((static_cast<float>(below(random, 2000)) - 1000.0f) / 8.0f);
}

/// `index`, from 1, as it stands or counted from the latest of `count`.
std::string written_index(Random& random, std::uint32_t index, std::uint32_t count) {
    if (below(random, 2) == 0) return std::to_string(index);
    return std::to_string(static_cast<std::int64_t>(index) - static_cast<std::int64_t>(count) - 1);
}

std::string random_corner(Random& random, std::uint32_t points, std::uint32_t form) {
    const auto index = [&] { return written_index(random, 1 + below(random, points), points); };
    std::string corner = index();
    if (form == 1 || form == 3) corner += "/" + index();
    if (form == 2) corner += "/";
    if (form == 2 || form == 3) corner += "/" + index();
    return corner;
}

/// A valid OBJ file with every statement both readers know.
std::string random_obj(Random& random) {
    std::string text = "mtllib some.mtl\n";
    const std::uint32_t points = 3 + below(random, 20);
    for (std::uint32_t i = 0; i < points; ++i) {
        text += "v " + eighths(random) + " " + eighths(random) + " " + eighths(random) + "\n";
        text += "vt " + eighths(random) + "\t" + eighths(random) + "\n";
        text += "vn " + eighths(random) + " " + eighths(random) + "  " + eighths(random) + "\n";
    }
    for (std::uint32_t f = below(random, 30); f > 0; --f) {
        const std::uint32_t form = below(random, 4);
        if (below(random, 4) == 0) text += "usemtl m" + std::to_string(below(random, 3)) + "\n";
        if (below(random, 8) == 0) text += "s 1\n# a comment\n\n";
        text += "f";
        for (std::uint32_t n = 3 + below(random, 6); n > 0; --n) {
            text += " " + random_corner(random, points, form);
        }
        text += "\n";
    }
    return text;
}

const std::string some_mtl =
    "newmtl m0\nKd 1 0 0\nKa 0.5 0.25 0.125\nKs 0.5 0.5 0.5\nNs 12.5\nd 0.5\nNi 1.5\nillum 2\n"
    "newmtl m1\nKd 0 1 0\nTr 0.25\nnewmtl m2\nKd 0 0 1\nillum 0\n";

std::optional<Bytes> open_some_mtl(std::string_view) {
    auto data = std::make_unique<char[]>(some_mtl.size());
    std::ranges::copy(some_mtl, data.get());
    return Bytes(std::move(data), some_mtl.size());
}

std::uint32_t index_or_none(int index) {
    return index < 0 ? PolygonSoup::none : static_cast<std::uint32_t>(index);
}

void expect_same_points(const PolygonSoup& soup, const tinyobj::attrib_t& theirs) {
    ASSERT_EQ(soup.positions.size() * 3, theirs.vertices.size());
    ASSERT_EQ(soup.normals.size() * 3, theirs.normals.size());
    ASSERT_EQ(soup.uvs.size() * 2, theirs.texcoords.size());
    for (std::size_t i = 0; i < theirs.vertices.size(); ++i) {
        const auto axis = static_cast<int>(i % 3);
        ASSERT_EQ(soup.positions[i / 3][axis], theirs.vertices[i]);
        ASSERT_EQ(soup.normals[i / 3][axis], theirs.normals[i]);
    }
    for (std::size_t i = 0; i < theirs.texcoords.size(); ++i) {
        ASSERT_EQ(soup.uvs[i / 2][static_cast<int>(i % 2)], theirs.texcoords[i]);
    }
}

void expect_same_material(const PolygonSoup& soup, std::size_t face, int theirs,
                          const std::vector<tinyobj::material_t>& materials) {
    const Material ours =
        soup.face_material.empty() ? Material{} : soup.materials[soup.face_material[face]];
    if (theirs < 0) {
        ASSERT_EQ(ours.name, "");
        return;
    }
    const tinyobj::material_t& material = materials[static_cast<std::size_t>(theirs)];
    ASSERT_EQ(ours.name, material.name);
    for (const int i : {0, 1, 2})
        ASSERT_EQ(ours.diffuse[i], material.diffuse[i]);
    ASSERT_EQ(ours.opacity, material.dissolve);
    if (ours.name != "m0") return;  // the others leave these to each reader's defaults
    for (const int i : {0, 1, 2})
        ASSERT_EQ(ours.ambient[i], material.ambient[i]);
    for (const int i : {0, 1, 2})
        ASSERT_EQ(ours.specular[i], material.specular[i]);
    ASSERT_EQ(ours.exponent, material.shininess);
    ASSERT_EQ(ours.refraction, material.ior);
    ASSERT_EQ(ours.illumination, material.illum);
}

void expect_same_faces(const PolygonSoup& soup, const tinyobj::ObjReader& theirs) {
    std::size_t face = 0;
    std::size_t corner = 0;
    for (const tinyobj::shape_t& shape : theirs.GetShapes()) {
        std::size_t in_shape = 0;
        for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); ++f, ++face) {
            ASSERT_EQ(soup.face(face).size(), shape.mesh.num_face_vertices[f]);
            expect_same_material(soup, face, shape.mesh.material_ids[f], theirs.GetMaterials());
            for (std::size_t i = 0; i < shape.mesh.num_face_vertices[f]; ++i, ++corner) {
                const tinyobj::index_t& index = shape.mesh.indices[in_shape++];
                ASSERT_EQ(soup.corners[corner].position, index_or_none(index.vertex_index));
                ASSERT_EQ(soup.corners[corner].uv, index_or_none(index.texcoord_index));
                ASSERT_EQ(soup.corners[corner].normal, index_or_none(index.normal_index));
            }
        }
    }
    ASSERT_EQ(face, soup.face_count());
}

TEST(LoadLaws, AgreesWithTinyobjloaderOnValidFiles) {
    Random random(4);
    for (int i = 0; i < 2000 && !HasFailure(); ++i) {
        const std::string text = random_obj(random);
        const PolygonSoup ours = load_obj(text, "file", open_some_mtl);
        tinyobj::ObjReaderConfig config;
        config.triangulate = false;
        tinyobj::ObjReader theirs;
        ASSERT_TRUE(theirs.ParseFromString(text, some_mtl, config)) << theirs.Error();
        expect_same_points(ours, theirs.GetAttrib());
        expect_same_faces(ours, theirs);
        if (HasFailure()) ADD_FAILURE() << text;
    }
}

}  // namespace
}  // namespace scanlight::mesh
