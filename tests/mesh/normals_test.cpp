#include "mesh/normals.h"

#include <limits>

#include <gtest/gtest.h>

#include "mesh/build.h"
#include "mesh/shapes.h"
#include "mesh/triangulate.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

constexpr NormalWeight every_weight[] = {NormalWeight::mean, NormalWeight::area,
                                         NormalWeight::angle, NormalWeight::file};

/// The normal of the first vertex at a place.
glm::vec3 normal_at(const Mesh& mesh, const glm::vec3& place) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (mesh.vertices.position(i) == place) return mesh.vertices.normal(i);
    }
    ADD_FAILURE() << "no such vertex";
    return {};
}

Mesh built(const PolygonSoup& soup, NormalWeight weight, float crease_deg) {
    return build(soup, {weight, crease_deg}).mesh;
}

bool is_flat(const Mesh& mesh) {
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        for (const std::uint32_t v : mesh.face(face)) {
            if (distance(mesh.vertices.normal(v), mesh.face_normals[face]) > 1e-6f) return false;
        }
    }
    return true;
}

/// Two faces back to back, on the same points.
PolygonSoup pillow() {
    return soup_of({{0, 0, 0}, {1, 0, 0}, {0.3f, 0.9f, 0.2f}}, {{0, 1, 2}, {0, 2, 1}});
}

TEST(Normals, VNOR_a_ACubeCornerIsTheMeanOfItsThreeFaces) {
    const Mesh mesh = built(shape("cube"), NormalWeight::mean, 180);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_LT(distance(normal_at(mesh, {1, 1, 1}), {0.577350269f, 0.577350269f, 0.577350269f}),
              1e-7f);
}

TEST(Normals, VNOR_b_c_TheMeanOfUnitNormalsMadeUnit) {
    // The faces' normals at the origin: z, (1, 0, 1), (0, 1, 1); their sizes differ and must not
    // matter.
    const Mesh mesh = built(
        soup_of({{0, 0, 0}, {-1, 0, 0}, {0, -5, 0}, {2, 2, -2}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}),
        NormalWeight::mean, 180);
    const glm::vec3 mean =
        (mesh.face_normals[0] + mesh.face_normals[1] + mesh.face_normals[2]) / 3.0f;
    EXPECT_LT(distance(mean, {0.23570226f, 0.23570226f, 0.804737854f}), 1e-7f);
    EXPECT_NEAR(glm::length(mean), 0.871041977f, 1e-7f);
    EXPECT_LT(distance(normal_at(mesh, {0, 0, 0}), {0.27059805f, 0.27059805f, 0.923879533f}),
              1e-7f);
}

TEST(Normals, VNOR_d_TheAreaWeighsTwoToOne) {
    const Mesh mesh =
        built(soup_of({{0, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, 0, -1}}, {{0, 1, 2}, {1, 0, 3}}),
              NormalWeight::area, 180);
    EXPECT_LT(distance(normal_at(mesh, {0, 0, 0}), {0.447213595f, 0, 0.894427191f}), 1e-7f);
}

TEST(Normals, AnglesWeighSoThatTheCutOfAQuadDoesNotMatter) {
    const PolygonSoup whole = shape("cube");
    PolygonSoup cut;
    cut.positions = whole.positions;
    for (std::size_t face = 0; face < whole.face_count(); ++face) {
        const auto quad = whole.face(face);
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            for (const int i : {a, b, c}) {
                cut.corners.push_back(quad[static_cast<std::size_t>(i)]);
            }
            cut.face_begin.push_back(static_cast<std::uint32_t>(cut.corners.size()));
        }
    }
    float worst_mean = 0.0f;
    for (const glm::vec3& corner : whole.positions) {
        const glm::vec3 outward = glm::normalize(corner);
        const Mesh by_angle = built(cut, NormalWeight::angle, 180);
        EXPECT_LT(distance(normal_at(by_angle, corner), outward), 1e-7f);
        const Mesh by_mean = built(cut, NormalWeight::mean, 180);
        worst_mean = std::max(worst_mean, distance(normal_at(by_mean, corner), outward));
    }
    EXPECT_GT(worst_mean, 0.1f);
}

TEST(Normals, AReflexCornerWeighsWithItsInnerAngle) {
    // At the origin an L of 270 degrees in z = 0 and a wall of 90 degrees below its notch.
    const Mesh mesh = built(soup_of({{0, 0, 0},
                                     {0, 1, 0},
                                     {-1, 1, 0},
                                     {-1, -1, 0},
                                     {1, -1, 0},
                                     {1, 0, 0},
                                     {1, 0, -1},
                                     {0, 0, -1}},
                                    {{0, 1, 2, 3, 4, 5}, {0, 5, 6, 7}}),
                            NormalWeight::angle, 180);
    EXPECT_LT(distance(normal_at(mesh, {0, 0, 0}), glm::normalize(glm::vec3(0, 1, 3))), 1e-6f);
}

TEST(Normals, ACubeKeepsItsEdgesBelowTheCreaseAngleOnly) {
    for (const NormalWeight weight : every_weight) {
        const Mesh sharp = built(shape("cube"), weight, 60);
        EXPECT_TRUE(is_flat(sharp));
        EXPECT_EQ(sharp.vertices.size(), 24u);
        EXPECT_TRUE(is_flat(built(shape("cube"), weight, 89.99f)));
        EXPECT_EQ(built(shape("cube"), weight, 90).vertices.size(), 8u);
        EXPECT_EQ(built(shape("cube"), weight, 0).vertices.size(), 24u);
    }
}

TEST(Normals, ACylinderIsRoundOnItsSideAndFlatOnItsEnds) {
    const Mesh mesh = built(shape("cylinder:48"), NormalWeight::mean, 60);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        for (const std::uint32_t v : mesh.face(face)) {
            const glm::vec3 p = mesh.vertices.position(v);
            const glm::vec3 expected = face < 48 ? glm::vec3(p.x, 0, p.z) : glm::vec3(0, p.y, 0);
            ASSERT_LT(distance(mesh.vertices.normal(v), expected), 1e-6f);
        }
    }
}

TEST(Normals, ASingleCreaseThatEndsInAVertexDoesNotCutItsFan) {
    // A closed fan of four faces around the origin; only one edge is sharp enough to be a crease.
    const PolygonSoup fan = soup_of({{0, 0, 0}, {1, 0, 0.6f}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
    const Mesh mesh = built(fan, NormalWeight::mean, 40);
    std::size_t at_origin = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        at_origin += mesh.vertices.position(i) == glm::vec3(0.0f) ? 1 : 0;
    }
    EXPECT_EQ(at_origin, 1u);
}

TEST(Normals, FacesBackToBackKeepTheirOwn) {
    for (const NormalWeight weight : every_weight) {
        for (const float crease : {0.0f, 60.0f, 179.0f, 180.0f}) {
            EXPECT_TRUE(is_flat(built(pillow(), weight, crease)));
        }
    }
}

TEST(Normals, ATinyTriangleFarOutKeepsItsDirection) {
    // Steps of a float at 1e4 are 1/1024; the exact normal of these is that of the steps alone.
    const glm::vec3 far(1e4f, -1e4f, 1e4f);
    const glm::vec3 a = glm::vec3(9, 2, 1) / 1024.0f;
    const glm::vec3 b = glm::vec3(-3, 8, 4) / 1024.0f;
    const Mesh mesh = built(soup_of({far, far + a, far + b}, {{0, 1, 2}}), NormalWeight::mean, 60);
    const glm::vec3 exact = glm::normalize(glm::cross(glm::dvec3(a), glm::dvec3(b)));
    EXPECT_LT(distance(mesh.face_normals[0], exact), 1e-7f);
    EXPECT_LT(distance(mesh.vertices.normal(0), exact), 1e-7f);
}

TEST(Normals, SizesFromDenormalToHugeGiveTheSameNormals) {
    const PolygonSoup ball = shape("icosphere:2");
    const float denormal = std::numeric_limits<float>::denorm_min();
    for (const NormalWeight weight : every_weight) {
        const Mesh same = built(ball, weight, 60);
        for (const float scale : {1e-30f, 1e18f, 3e38f}) {
            const Mesh mesh = built(scaled(ball, scale), weight, 60);
            ASSERT_EQ(mesh.corners, same.corners);
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                ASSERT_LT(distance(mesh.vertices.normal(i), same.vertices.normal(i)), 1e-5f);
            }
        }
        const Mesh cube = built(scaled(shape("cube"), 7 * denormal), weight, 60);
        EXPECT_EQ(cube.face_count(), 6u);
        EXPECT_TRUE(is_flat(cube));
        EXPECT_TRUE(all_normals_are_unit(cube));
    }
}

TEST(Normals, FileNormalsAreTakenMadeUnitAndFilledUp) {
    PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    soup.normals = {{3, 0, 4}, {0, 0, 0}, {1e-40f, 0, 0}};
    soup.corners[0].normal = 0;
    soup.corners[1].normal = 1;
    const Mesh from_file = built(soup, NormalWeight::file, 60);
    EXPECT_LT(distance(from_file.vertices.normal(0), {0.6f, 0, 0.8f}), 1e-7f);
    EXPECT_EQ(from_file.vertices.normal(1), glm::vec3(0, 0, 1));  // zero there
    EXPECT_EQ(from_file.vertices.normal(2), glm::vec3(0, 0, 1));  // none there
    EXPECT_EQ(built(soup, NormalWeight::mean, 60).vertices.normal(0), glm::vec3(0, 0, 1));
    soup.corners[2].normal = 2;
    EXPECT_EQ(built(soup, NormalWeight::file, 60).vertices.normal(2), glm::vec3(1, 0, 0));
}

TEST(Normals, RandomSoupsGiveUnitNormalsUnderEveryRule) {
    Dice dice(4);
    for (int round = 0; round < 500; ++round) {
        std::vector<glm::vec3> points;
        const double scale = std::pow(10.0, dice.between(-38, 38));
        for (int i = 0; i < 8; ++i) {
            points.push_back(scale * glm::dvec3(dice.between(-1, 1), dice.between(-1, 1),
                                                dice.between(-1, 1) * dice.below(2)));
        }
        Faces faces;
        for (int i = 0; i < 16; ++i) {
            faces.push_back({dice.below(8), dice.below(8), dice.below(8), dice.below(8)});
        }
        for (const NormalWeight weight : every_weight) {
            ASSERT_TRUE(all_normals_are_unit(
                built(soup_of(points, faces), weight, static_cast<float>(dice.between(0, 200)))));
        }
    }
}

}  // namespace
}  // namespace scanlight::mesh
