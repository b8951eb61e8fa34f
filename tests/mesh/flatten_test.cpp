#include "mesh/flatten.h"

#include <gtest/gtest.h>

#include "mesh/build.h"
#include "mesh/shapes.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Two triangles in one plane; points 1 and 2 are shared, and the first face begins at point 3.
PolygonSoup kite() {
    return soup_of({{1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{3, 1, 2}, {1, 0, 2}});
}

TEST(Flatten, VerticesAreNumberedByFirstUse) {
    const Mesh mesh = build(kite()).mesh;
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(mesh.vertices.position(0), glm::vec3(0, 0, 0));
    EXPECT_EQ(mesh.vertices.position(3), glm::vec3(1, 1, 0));
    EXPECT_FALSE(mesh.vertices.has_uvs());
    EXPECT_FALSE(mesh.vertices.has_colors());
}

TEST(Flatten, AUvSeamDoublesAPointByValueNotByIndex) {
    PolygonSoup soup = kite();
    soup.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {5, 5}};
    const Indices uv{0, 1, 2, 3, PolygonSoup::none, 4};  // 1 and 3 are equal; 2 and 4 are not
    for (std::size_t c = 0; c < uv.size(); ++c) {
        soup.corners[c].uv = uv[c];
    }
    const Mesh mesh = build(soup).mesh;
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 1, 3, 4}));
    EXPECT_EQ(mesh.vertices.uv(1), glm::vec2(1, 0));
    EXPECT_EQ(mesh.vertices.uv(3), glm::vec2(0, 0));  // none given
    EXPECT_EQ(mesh.vertices.uv(4), glm::vec2(5, 5));
    EXPECT_EQ(mesh.vertices.position(2), mesh.vertices.position(4));
}

TEST(Flatten, ColorsGoWithTheirPoints) {
    PolygonSoup soup = kite();
    soup.colors = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.3f}};
    const Mesh mesh = build(soup).mesh;
    ASSERT_TRUE(mesh.vertices.has_colors());
    EXPECT_EQ(mesh.vertices.color(0), soup.colors[3]);
    EXPECT_EQ(mesh.vertices.color(1), soup.colors[1]);
}

TEST(Flatten, IdsAndMaterialsFollowTheirFacesPastDroppedOnes) {
    PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 1}, {0, 1, 2}, {0, 0, 1}, {0, 1, 3}});
    soup.materials.resize(4);
    soup.materials[2].name = "second";
    soup.face_material = {0, 2, 1, 3};
    const Mesh mesh = build(soup).mesh;
    EXPECT_EQ(mesh.face_id, (Indices{1, 3}));
    EXPECT_EQ(mesh.face_material, (Indices{2, 3}));
    EXPECT_EQ(mesh.materials[2].name, "second");
}

TEST(Flatten, UvsAndNormalsFollowTheirCornersPastDroppedOnes) {
    // A face that goes by a point twice in a row, one without area, and one behind both.
    PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 1, 2}, {0, 1, 1, 3}, {0, 0, 1}, {0, 3, 2}});
    soup.normals = {{0, 0, 1}, {0, 1, 0}};
    for (std::uint32_t c = 0; c < soup.corners.size(); ++c) {
        soup.uvs.emplace_back(static_cast<float>(c), 0.5f);
        soup.corners[c].uv = c;
        soup.corners[c].normal = c < 10 ? 0 : 1;
    }
    const Mesh mesh = build(soup, {.weight = NormalWeight::file}).mesh;
    std::vector<float> u;
    for (const std::uint32_t corner : mesh.corners)
        u.push_back(mesh.vertices.u[corner]);
    EXPECT_EQ(u, (std::vector<float>{0, 1, 2, 3, 4, 6, 10, 11, 12}));
    EXPECT_EQ(mesh.vertices.normal(mesh.corners[5]), soup.normals[0]);
    EXPECT_EQ(mesh.vertices.normal(mesh.corners[6]), soup.normals[1]);
}

TEST(Flatten, FacesOfTwoMaterialsShareNoVertex) {
    PolygonSoup soup = kite();
    soup.materials.resize(2);
    soup.face_material = {0, 1};
    const Mesh mesh = build(soup).mesh;
    EXPECT_EQ(mesh.corners, (Indices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.vertices.position(1), mesh.vertices.position(3));
    EXPECT_EQ(mesh.vertices.normal(1), mesh.vertices.normal(3));
}

TEST(Flatten, ASoupWithoutMaterialsGetsADefault) {
    const Mesh mesh = build(kite()).mesh;
    EXPECT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.face_material, (Indices{0, 0}));
}

TEST(Flatten, ManyNormalsInOnePointAreNoTrouble) {
    // The apex of a flat-shaded cone has a normal for each of its faces.
    const Mesh mesh = build(shape("cone:50000"), {.crease_deg = 0.0f}).mesh;
    EXPECT_EQ(mesh.face_count(), 50001u);
}

}  // namespace
}  // namespace scanlight::mesh
