#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include "mesh/build.h"
#include "mesh/ear_clipping.h"
#include "mesh/shapes.h"
#include "mesh/trigonometry.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

using Polygon = std::vector<glm::vec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// n - 2 triangles, none turned over, that together have the polygon's area.
void expect_covers(const Polygon& polygon, double tolerance) {
    const Triangles triangles = cut_ears(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    const glm::dvec3 whole = area_of(polygon);
    const glm::dvec3 up = glm::normalize(whole);
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double area = glm::dot(area_of({polygon[a], polygon[b], polygon[c]}), up);
        ASSERT_GE(area, -tolerance * glm::length(whole));
        sum += area;
    }
    ASSERT_NEAR(sum, glm::length(whole), tolerance * glm::length(whole));
}

/// Around the origin at ascending angles, so that it can't cross itself; on a tilted plane.
Polygon random_polygon(Dice& dice, std::uint32_t corners) {
    const glm::dvec3 across(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1));
    const glm::dvec3 up = glm::cross(across, glm::dvec3(0.3, -0.5, 0.8));
    Polygon polygon;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 2 * pi * (i + dice.between(0, 0.9)) / corners;
        const double radius = dice.between(0.05, 1.0);
        polygon.emplace_back(radius * cosine(angle) * across + radius * sine(angle) * up);
    }
    return polygon;
}

TEST(Triangulate, RandomSimplePolygonsKeepTheirArea) {
    Dice dice(5);
    for (int round = 0; round < 5000; ++round) {
        expect_covers(random_polygon(dice, 4 + dice.below(40)), 1e-5);
    }
}

TEST(Triangulate, PolygonsOnAGridWithCornersInLineKeepTheirArea) {
    // A skyline over a base line: many corners lie in one line, many more touch ears' rims.
    Dice dice(6);
    for (int round = 0; round < 2000; ++round) {
        Polygon polygon{{0, -1, 0}};
        const std::uint32_t columns = 2 + dice.below(20);
        for (std::uint32_t i = 1; i <= columns; ++i) {
            polygon.emplace_back(i, -1, 0);
        }
        for (std::uint32_t i = columns; i > 0; --i) {
            const std::uint32_t height = dice.below(3);
            polygon.emplace_back(i, height, 0);
            polygon.emplace_back(i - 1, height, 0);
        }
        Polygon distinct;
        for (const glm::vec3& p : polygon) {
            if (distinct.empty() || distinct.back() != p) distinct.push_back(p);
        }
        expect_covers(distinct, 1e-12);
    }
}

TEST(Triangulate, ASpiralKeepsItsArea) {
    Polygon spiral;
    constexpr int steps = 400;
    for (int i = 0; i < 2 * steps; ++i) {
        const int step = i < steps ? i : 2 * steps - 1 - i;
        const double radius = 1.0 + 0.02 * step + (i < steps ? 0.5 : 0.0);
        spiral.emplace_back(radius * cosine(0.1 * step), radius * sine(0.1 * step), 0.0);
    }
    expect_covers(spiral, 1e-6);
}

TEST(Triangulate, AQuadIsCutFromItsFirstCorner) {
    const Polygon quad{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(cut_ears(quad), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const Polygon dart{{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}};
    EXPECT_EQ(cut_ears(dart), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const Polygon turned_dart{{2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}, {0, 0, 0}};
    expect_covers(turned_dart, 1e-12);
}

TEST(Triangulate, AHoleOnABridgeStaysAHole) {
    expect_covers({{0, 0, 0},
                   {3, 0, 0},
                   {3, 3, 0},
                   {0, 3, 0},
                   {0, 0, 0},
                   {1, 1, 0},
                   {1, 2, 0},
                   {2, 2, 0},
                   {2, 1, 0},
                   {1, 1, 0}},
                  1e-12);
}

TEST(Triangulate, PolygonsThatCrossThemselvesOrHaveNoAreaLoseNoTriangle) {
    Dice dice(7);
    for (std::uint32_t round = 0; round < 2000; ++round) {
        Polygon knot;
        for (std::uint32_t i = 4 + dice.below(20); i > 0; --i) {
            knot.emplace_back(dice.below(4), dice.below(4), dice.below(1 + round % 3));
        }
        ASSERT_EQ(cut_ears(knot).size(), knot.size() - 2);
    }
    EXPECT_EQ(cut_ears(Polygon(9, {1, 2, 3})).size(), 7u);
    EXPECT_EQ(cut_ears(Polygon{{0, 0, 0}, {1, 0, 0}}).size(), 0u);
}

TEST(Triangulate, AHundredThousandCornersAreNoTrouble) {
    for (const char* name : {"ngon:100000", "star:50000"}) {
        const Mesh mesh = build(shape(name)).mesh;
        expect_covers(points_of_face(mesh, 0), 1e-6);
    }
    Dice dice(8);
    expect_covers(random_polygon(dice, 100000), 1e-4);
    Polygon knot;
    for (int i = 0; i < 100000; ++i) {
        knot.emplace_back(dice.between(-1, 1), dice.between(-1, 1), 0);
    }
    EXPECT_EQ(cut_ears(knot).size(), 99998u);
}

TEST(Triangulate, TrianglesKeepTheirPolygonsIdMaterialAndNormal) {
    PolygonSoup soup = shape("cylinder:7");
    soup.materials.resize(3);
    for (std::uint32_t face = 0; face < soup.face_count(); ++face) {
        soup.face_material.push_back(face % 3);
    }
    const Mesh mesh = build(soup).mesh;
    const Mesh cut = triangulated(mesh);
    ASSERT_EQ(cut.face_count(), 7u * 2 + 5 + 5);
    EXPECT_EQ(cut.materials.size(), 3u);
    EXPECT_EQ(cut.vertices.size(), mesh.vertices.size());
    std::vector<glm::dvec3> area(mesh.face_count(), glm::dvec3(0.0));
    for (std::size_t face = 0; face < cut.face_count(); ++face) {
        const std::uint32_t id = cut.face_id[face];
        EXPECT_EQ(cut.face_material[face], mesh.face_material[id]);
        EXPECT_EQ(cut.face_normals[face], mesh.face_normals[id]);
        EXPECT_NEAR(cut.face_offset[face], mesh.face_offset[id], 1e-6);
        area[id] += area_of(points_of_face(cut, face));
    }
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        EXPECT_LT(glm::length(area[face] - area_of(points_of_face(mesh, face))), 1e-6);
    }
}

}  // namespace
}  // namespace scanlight::mesh
