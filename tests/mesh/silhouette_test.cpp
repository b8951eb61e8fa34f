#include "mesh/silhouette.h"

#include <gtest/gtest.h>

#include <map>

#include "mesh/build.h"
#include "mesh/shapes.h"

namespace scanlight::mesh {
namespace {

Mesh shape_mesh(const char* text) {
    return build(shape(text), {}).mesh;
}

/// Vertices of their own for each face: nothing but their places joins them.
Mesh of_triangles(const std::vector<glm::vec3>& corners) {
    PolygonSoup soup;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        soup.positions.push_back(corners[i]);
        soup.corners.push_back({i, PolygonSoup::none, PolygonSoup::none});
        if (i % 3 == 2) soup.face_begin.push_back(i + 1);
    }
    Mesh mesh = build(soup, {}).mesh;
    return mesh;
}

std::vector<SilhouetteEdge> silhouette_of(const Mesh& mesh, const glm::dvec4& viewpoint) {
    return SilhouetteFinder(mesh).from(viewpoint).edges;
}

TEST(Edges, OfACubeAreTwelveWithTwoFacesEach) {
    const Edges edges = edges_of(shape_mesh("cube"));
    ASSERT_EQ(edges.size(), 12u);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto uses = edges.uses_of(e);
        ASSERT_EQ(uses.size(), 2u);
        EXPECT_EQ(uses[0].direction + uses[1].direction, 0);  // in opposite directions
    }
}

TEST(Facing, OfACubeSeenAlongAnAxisIsOneFrontAndOneBack) {
    int count[3] = {};
    for (const Facing face : SilhouetteFinder(shape_mesh("cube")).from({0.0, 0.0, 1.0, 0.0}).facing)
        ++count[static_cast<int>(face) + 1];
    EXPECT_EQ(count[0], 1);
    EXPECT_EQ(count[1], 4);
    EXPECT_EQ(count[2], 1);
}

TEST(Silhouette, OfACubeSeenFromACornerIsItsHexagonTwice) {
    const auto edges = silhouette_of(shape_mesh("cube"), {5.0, 5.0, 5.0, 1.0});
    EXPECT_EQ(edges.size(), 6u);
    for (const SilhouetteEdge& edge : edges)
        EXPECT_EQ(std::abs(edge.multiplicity), 2);
}

TEST(Silhouette, OfAnOpenMeshIsItsBoundaryOnce) {
    const auto edges = silhouette_of(shape_mesh("plane:4"), {0.3, 5.0, 0.1, 1.0});
    EXPECT_EQ(edges.size(), 16u);
    for (const SilhouetteEdge& edge : edges)
        EXPECT_EQ(std::abs(edge.multiplicity), 1);
}

TEST(Silhouette, HasNoEdgeBetweenFacesOfOpposedOrientation) {
    const Mesh mesh = of_triangles({{0, 0, 0},
                                    {1, 0, 0},
                                    {0, 1, 0},  // seen from its front
                                    {1, 0, 0},
                                    {0, 1, 0},
                                    {1, 1, 0}});  // and from its back
    const auto edges = silhouette_of(mesh, {0.0, 0.0, 1.0, 0.0});
    EXPECT_EQ(edges.size(), 4u);
}

TEST(Silhouette, CountsAFaceThatIsThereTwiceTwice) {
    const Mesh mesh =
        of_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    for (const SilhouetteEdge& edge : silhouette_of(mesh, {0.0, 0.0, 1.0, 0.0}))
        EXPECT_EQ(std::abs(edge.multiplicity), 2);
}

// What goes out of a point along the silhouette comes in again: it is made of closed loops.
TEST(Silhouette, LeavesAndEntersEachPointEquallyOften) {
    for (const char* shape : {"teapot", "torus:9,7", "star:5", "sphere:8,5", "plane:3"}) {
        const Mesh mesh = shape_mesh(shape);
        for (const glm::dvec4 viewpoint :
             {glm::dvec4(1.0, 2.0, 3.0, 0.0), glm::dvec4(0.2, 0.1, -0.3, 1.0)}) {
            std::map<std::uint32_t, int> balance;
            for (const auto& [from, to, multiplicity] : silhouette_of(mesh, viewpoint)) {
                balance[from] += multiplicity;
                balance[to] -= multiplicity;
            }
            for (const auto& [vertex, sum] : balance)
                EXPECT_EQ(sum, 0) << shape << " at vertex " << vertex;
        }
    }
}

}  // namespace
}  // namespace scanlight::mesh
