#include "mesh/shapes.h"

#include <array>
#include <map>

#include <gtest/gtest.h>

#include "mesh/bounds.h"
#include "mesh/build.h"
#include "mesh/corner_text.h"
#include "mesh/file_error.h"
#include "mesh/teapot.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

std::string message_of(const std::string& text) {
    try {
        shape(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Shapes, ClosedOnesHaveTheirEulerNumberAndLookOutward) {
    const std::map<std::string, int> euler{
        {"cube", 2},        {"tetrahedron", 2}, {"octahedron", 2},   {"icosphere:0", 2},
        {"icosphere:4", 2}, {"sphere", 2},      {"sphere:3,2", 2},   {"sphere:257,101", 2},
        {"torus", 0},       {"torus:3,3", 0},   {"cylinder:3", 2},   {"cylinder", 2},
        {"cone:3", 2},      {"cone", 2},        {"torus:100,31", 0}, {"cone:1000", 2}};
    for (const auto& [name, number] : euler) {
        const auto [mesh, report] = build(shape(name));
        EXPECT_TRUE(report.closed()) << name;
        EXPECT_TRUE(report.manifold()) << name;
        EXPECT_EQ(report.euler_number(), number) << name;
        EXPECT_EQ(report.components, 1u) << name;
        EXPECT_EQ(report.faces_in, report.drawn) << name;
        EXPECT_EQ(report.isolated_points, 0u) << name;
        EXPECT_GT(volume_of(mesh), 0.1) << name;
        EXPECT_TRUE(all_normals_are_unit(mesh)) << name;
    }
}

TEST(Shapes, EveryListedOneBuildsWithoutParametersWithinItsRoom) {
    EXPECT_EQ(list_shapes().size(), 14u);
    for (const ShapeInfo& info : list_shapes()) {
        EXPECT_TRUE(is_shape(info.name));
        const auto [mesh, report] = build(shape(info.name));
        EXPECT_TRUE(report.manifold()) << info.name;
        EXPECT_EQ(report.faces_in, report.drawn) << info.name;
        const Box box = bounding_box(mesh);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(box.low[axis], -2.0) << info.name;
            EXPECT_LE(box.high[axis], 2.0) << info.name;
        }
    }
}

TEST(Shapes, FlatOnesFaceUpOrForward) {
    for (const auto& [name, normal] :
         std::map<std::string, glm::vec3>{{"plane:3", {0, 1, 0}},
                                          {"ngon:7", {0, 0, 1}},
                                          {"star:9", {0, 0, 1}},
                                          {"polygon:0,0:1,0:0,1", {0, 0, 1}},
                                          {"polygon:0,0:0,1:1,0", {0, 0, 1}}}) {
        for (const glm::vec3& n : build(shape(name)).mesh.face_normals) {
            EXPECT_EQ(n, normal) << name;
        }
    }
}

TEST(Shapes, ParametersCountWhatTheySay) {
    EXPECT_EQ(shape("icosphere:3").face_count(), 20u * 64);
    EXPECT_EQ(shape("sphere:10,6").face_count(), 60u);
    EXPECT_EQ(shape("torus:10,6").face_count(), 60u);
    EXPECT_EQ(shape("torus:10").face_count(), 240u);
    EXPECT_EQ(shape("cylinder:10").face_count(), 12u);
    EXPECT_EQ(shape("cone:10").face_count(), 11u);
    EXPECT_EQ(shape("plane:10").face_count(), 100u);
    EXPECT_EQ(shape("ngon:10").corners.size(), 10u);
    EXPECT_EQ(shape("star:10").corners.size(), 20u);
    EXPECT_EQ(shape("teapot:4").face_count(), 32u * 16);
}

TEST(Shapes, QuadsAreQuadsAndPolesAreTriangles) {
    const PolygonSoup sphere = shape("sphere:10,6");
    for (std::size_t face = 0; face < sphere.face_count(); ++face) {
        EXPECT_EQ(sphere.face(face).size(), face < 10 || face >= 50 ? 3u : 4u);
    }
}

TEST(Shapes, BallsAreRoundToTheLastBits) {
    for (const char* name : {"icosphere:5", "sphere:64,33"}) {
        for (const glm::vec3& p : shape(name).positions) {
            ASSERT_NEAR(glm::length(glm::dvec3(p)), 1.0, 1e-7) << name;
        }
    }
    for (const glm::dvec3 p : shape("torus:31,17").positions) {
        const double off_ring = std::sqrt(p.x * p.x + p.z * p.z) - 0.7;
        ASSERT_NEAR(std::sqrt(off_ring * off_ring + p.y * p.y), 0.3, 1e-7);
    }
}

TEST(Shapes, UvsGrowToTheRightAndUpwardWithoutJumps) {
    for (const char* name : {"sphere:8,5", "torus:8,5", "plane:4"}) {
        const PolygonSoup soup = shape(name);
        for (std::size_t face = 0; face < soup.face_count(); ++face) {
            glm::vec2 low(9.0f);
            glm::vec2 high(-9.0f);
            double turning = 0.0;
            const auto corners = soup.face(face);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const glm::vec2 uv = soup.uvs[corners[i].uv];
                const glm::vec2 next = soup.uvs[corners[(i + 1) % corners.size()].uv];
                turning += double(uv.x) * next.y - double(uv.y) * next.x;
                low = glm::min(low, uv);
                high = glm::max(high, uv);
            }
            ASSERT_GT(turning, 0.0) << name;  // not mirrored
            ASSERT_LE(high.x - low.x, 0.2501f) << name;
            ASSERT_LE(high.y - low.y, 0.2501f) << name;
            ASSERT_GE(std::min(low.x, low.y), 0.0f) << name;
            ASSERT_LE(std::max(high.x, high.y), 1.0f) << name;
        }
    }
}

TEST(Shapes, AnUnknownNameGetsTheNearest) {
    EXPECT_EQ(message_of("taepot"), "no shape is named 'taepot'; the nearest is 'teapot'");
    EXPECT_NE(message_of("spere:3").find("'sphere'"), std::string::npos);
    EXPECT_NE(message_of("").find("no shape"), std::string::npos);
    EXPECT_FALSE(is_shape("taepot"));
    EXPECT_FALSE(is_shape(""));
    EXPECT_TRUE(is_shape("teapot:8"));
    EXPECT_FALSE(is_shape("teapot8"));
}

TEST(Shapes, AParameterOutOfRangeIsRefusedWithTheRange) {
    EXPECT_EQ(message_of("icosphere:9"),
              "shape icosphere: '9' can't be its level (0 to 8, default 3)");
    for (const char* text : {"icosphere:-1", "icosphere:", "icosphere:3,", "icosphere:x",
                             "icosphere:3x", "icosphere: 3", "icosphere:99999999999999999999",
                             "sphere:2,2", "sphere:3,1", "sphere:2049,2", "sphere:3,2,1", "cube:1",
                             "torus:,3", "teapot:1", "teapot:257", "ngon:2", "star:2", "plane:0"}) {
        EXPECT_NE(message_of(text), "no error") << text;
    }
    EXPECT_EQ(message_of("icosphere:0"), "no error");
    EXPECT_EQ(message_of("sphere:3,2"), "no error");
    EXPECT_EQ(message_of("cube:1"), "shape cube takes no parameters");
}

// ---- a polygon by its corners

std::vector<glm::vec3> corners_of(const std::string& text) {
    const PolygonSoup soup = shape(text);
    std::vector<glm::vec3> corners;
    for (const auto& corner : soup.face(0))
        corners.push_back(soup.positions[corner.position]);
    return corners;
}

std::string polygon_of(std::size_t corners) {
    std::string text = "polygon";
    for (std::size_t i = 0; i < corners; ++i) {
        const double x = static_cast<double>(i);
        text += ":" + std::to_string(x) + "," + std::to_string(0.01 * x * x);
    }
    return text;
}

TEST(PolygonShape, HasTheCornersThatAreSaid) {
    using Corners = std::vector<glm::vec3>;
    EXPECT_EQ(corners_of("polygon:0,1:-1,-1:0.5,-0.25"),
              (Corners{{0, 1, 0}, {-1, -1, 0}, {0.5, -0.25, 0}}));
    EXPECT_EQ(corners_of("polygon:1e3,-1000:1000,0:.5,0").size(), 3u);
    EXPECT_EQ(corners_of("polygon").size(), 4u);
}

TEST(PolygonShape, ThatGoesClockwiseIsTheSameOneTurned) {
    EXPECT_EQ(corners_of("polygon:0,0:0,2:1,1:2,0"), corners_of("polygon:0,0:2,0:1,1:0,2"));
}

TEST(PolygonShape, Has3To64Corners) {
    EXPECT_EQ(message_of(polygon_of(3)), "no error");
    EXPECT_EQ(message_of(polygon_of(64)), "no error");
    EXPECT_EQ(message_of(polygon_of(2)),
              "shape polygon: 2 corners, expected 3 to 64 as X,Y:X,Y:X,Y");
    EXPECT_EQ(message_of(polygon_of(65)),
              "shape polygon: 65 corners, expected 3 to 64 as X,Y:X,Y:X,Y");
    EXPECT_EQ(message_of("polygon:"), "shape polygon: 1 corner, expected 3 to 64 as X,Y:X,Y:X,Y");
}

TEST(PolygonShape, RefusesWhatIsNoCorner) {
    for (const std::string corner : {"", "1", "1,", ",1", "1,2,3", "1,x", "nan,0", "inf,0",
                                     "0,1001", "-1000.5,0", "1e99,0", " 1,2", "1;2", "0x1,0"}) {
        EXPECT_EQ(
            message_of("polygon:0,0:" + corner + ":1,0"),
            "shape polygon: \"" + corner + "\" is no corner X,Y of two numbers from -1000 to 1000");
    }
}

TEST(PolygonShape, HasAnArea) {
    for (const char* text :
         {"polygon:0,0:1,1:2,2", "polygon:1,1:1,1:1,1", "polygon:0,0:1,0:0,0:1,0"})
        EXPECT_EQ(message_of(text), "shape polygon: its corners enclose no area") << text;
    EXPECT_EQ(message_of("polygon:0,0:1,1:2,2.0001"), "no error");
}

TEST(PolygonShape, MayBeConcaveAndCrossItself) {
    for (const char* text : {"polygon:0,1:-1,-1:0,0:1,-1", "polygon:-1,-1:1,1:1,-1:-1,1"}) {
        const auto [mesh, report] = build(shape(text));
        EXPECT_EQ(report.drawn, 1u) << text;
        EXPECT_EQ(mesh.face_normals.at(0), glm::vec3(0, 0, 1)) << text;
    }
}

TEST(PolygonShape, ItsTextIsAsShortAsTellsTheNumbers) {
    for (const char* text : {"0.05,1.12:-1.7,0.2:3,0", "0,0:1,0:0.1,0.30000000000000004"})
        EXPECT_EQ(corners_text(parse_corners(text, "polygon")), text);
}

TEST(Teapot, HasNewellsSize) {
    const Box box = bounding_box(build(teapot(64)).mesh);  // half the original's, y centred
    EXPECT_EQ(box.low.x, -1.5);
    EXPECT_NEAR(box.high.x, 3.434 / 2, 1e-3);
    EXPECT_NEAR(box.size().y, 3.15 / 2, 1e-6);
    EXPECT_EQ(box.low.z, -1.0);
    EXPECT_EQ(box.high.z, 1.0);
}

TEST(Teapot, IsFourPiecesOpenOnlyAtTheirEnds) {
    for (const std::uint32_t n : {2u, 5u, 8u, 33u}) {
        const BuildReport report = build(teapot(n)).report;
        EXPECT_EQ(report.faces_in, 32u * n * n);
        EXPECT_EQ(report.drawn, report.faces_in);
        EXPECT_TRUE(report.manifold());
        EXPECT_EQ(report.components, 4u);
        // The rim and the lid have four patches around; handle and spout two, at both ends.
        EXPECT_EQ(report.boundary_edges, 4 * n + 4 * n + 2 * 2 * n + 2 * 2 * n);
    }
}

TEST(Teapot, IsItsOwnMirrorImage) {
    const PolygonSoup soup = teapot(8);
    for (const glm::vec3& p : soup.positions) {
        const glm::vec3 image(p.x, p.y, -p.z);
        const auto near = [&](const glm::vec3& q) { return distance(q, image) < 1e-6f; };
        ASSERT_TRUE(std::ranges::any_of(soup.positions, near));
    }
}

TEST(Teapot, LooksOutward) {
    // At the ends of each axis the normal leads away, up on the knob and down on the bottom.
    const Mesh mesh = build(teapot(16)).mesh;
    const std::array<double, 3> low{-1.48, -0.78, -0.95};
    const std::array<double, 3> high{9.0, 0.77, 0.95};  // the spout's end is a lip that curls in
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::vec3 p = mesh.vertices.position(i);
        const glm::vec3 n = mesh.vertices.normal(i);
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            ASSERT_TRUE(p[axis] > low[at] || n[axis] < -0.5f) << axis;
            ASSERT_TRUE(p[axis] < high[at] || n[axis] > 0.5f) << axis;
        }
    }
}

TEST(Teapot, IsSmoothAcrossItsSeams) {
    // The body is a surface of revolution: around it, normals must not leave the meridian plane.
    const Mesh mesh = build(teapot(16)).mesh;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::vec3 p = mesh.vertices.position(i);
        const glm::vec3 n = mesh.vertices.normal(i);
        const float radius = std::sqrt(p.x * p.x + p.z * p.z);
        // Beside the handle and the spout, which enter the body.
        const bool on_body = std::abs(p.y) < 0.3f && std::abs(p.z) > 0.35f;
        if (!on_body) continue;
        ASSERT_GT(n.x * p.x + n.z * p.z, 0.0f);
        ASSERT_LT(std::abs(n.x * p.z - n.z * p.x) / radius, 0.01f);
    }
}

}  // namespace
}  // namespace scanlight::mesh
