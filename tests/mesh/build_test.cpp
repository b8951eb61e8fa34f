#include "mesh/build.h"

#include <set>

#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

using Point = std::uint32_t;

std::vector<Point> points_in(const PolygonSoup& soup, std::size_t face) {
    std::vector<Point> points;
    for (const auto& corner : soup.face(face)) {
        points.push_back(corner.position);
    }
    return points;
}

/// The face without corners that repeat their neighbour.
std::vector<Point> without_repeats(const std::vector<Point>& points) {
    std::vector<Point> clean;
    for (const Point point : points) {
        if (clean.empty() || clean.back() != point) clean.push_back(point);
    }
    while (clean.size() > 1 && clean.back() == clean.front()) {
        clean.pop_back();
    }
    return clean;
}

/// Exact for points with small whole coordinates.
bool spans_an_area(const PolygonSoup& soup, const std::vector<Point>& face) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const glm::vec3 a = soup.positions[face[i]] - soup.positions[face[0]];
        const glm::vec3 b = soup.positions[face[i + 1]] - soup.positions[face[0]];
        if (glm::cross(a, b) != glm::vec3(0.0f)) return true;
    }
    return false;
}

/// Few points on a small grid, and faces that repeat points, each other and each other's reverse.
PolygonSoup random_soup(Dice& dice) {
    PolygonSoup soup;
    const Point points = 3 + dice.below(8);
    for (Point i = 0; i < points; ++i) {
        soup.positions.emplace_back(dice.below(3), dice.below(3), dice.below(3));
    }
    Faces faces;
    const std::uint32_t count = dice.below(24);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<Point> face;
        if (!faces.empty() && dice.below(4) == 0) {
            face = faces[dice.below(static_cast<std::uint32_t>(faces.size()))];
            if (dice.below(2) == 0) std::reverse(face.begin(), face.end());
        } else {
            const std::uint32_t corners = dice.below(3) == 0 ? dice.below(8) : 3;
            for (std::uint32_t c = 0; c < corners; ++c) {
                face.push_back(dice.below(points));
            }
        }
        faces.push_back(face);
    }
    return soup_of(soup.positions, faces);
}

const std::vector<glm::vec3> tetrahedron_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Faces tetrahedron_faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

/// A box from `low` to `low` + 1, its points looked up in `points` by place.
void add_cube(std::vector<glm::vec3>& points, Faces& faces, const glm::vec3& low) {
    const PolygonSoup cube = shape("cube");
    std::vector<Point> index;
    for (const glm::vec3& p : cube.positions) {
        const glm::vec3 place = low + (p + 1.0f) * 0.5f;
        const auto found = std::ranges::find(points, place);
        index.push_back(static_cast<Point>(found - points.begin()));
        if (found == points.end()) points.push_back(place);
    }
    for (std::size_t f = 0; f < cube.face_count(); ++f) {
        std::vector<Point> face;
        for (const Point point : points_in(cube, f)) {
            face.push_back(index[point]);
        }
        faces.push_back(face);
    }
}

PolygonSoup two_cubes(const glm::vec3& second) {
    std::vector<glm::vec3> points;
    Faces faces;
    add_cube(points, faces, {0, 0, 0});
    add_cube(points, faces, second);
    return soup_of(points, faces);
}

PolygonSoup in_order(const PolygonSoup& soup, const std::vector<std::size_t>& order) {
    Faces faces;
    for (const std::size_t face : order) {
        faces.push_back(points_in(soup, face));
    }
    return soup_of(soup.positions, faces);
}

TEST(Build, RandomSoupsDrawEveryPolygonAsItWasOrCountIt) {
    Dice dice(1);
    for (int round = 0; round < 20000; ++round) {
        const PolygonSoup soup = random_soup(dice);
        const auto [mesh, report] = build(soup);
        std::vector<std::uint32_t> drawn;
        std::size_t few = 0;
        for (std::uint32_t face = 0; face < soup.face_count(); ++face) {
            const std::vector<Point> points = without_repeats(points_in(soup, face));
            if (std::set(points.begin(), points.end()).size() < 3) {
                ++few;
            } else if (spans_an_area(soup, points)) {
                std::vector<glm::vec3> places;
                for (const Point point : points) {
                    places.push_back(soup.positions[point]);
                }
                ASSERT_LT(drawn.size(), mesh.face_count());
                ASSERT_EQ(points_of_face(mesh, drawn.size()), places);
                drawn.push_back(face);
            }
        }
        ASSERT_EQ(mesh.face_id, drawn);
        ASSERT_EQ(report.few_corners, few);
        ASSERT_EQ(report.faces_in, soup.face_count());
        ASSERT_EQ(report.faces_in, report.drawn + report.zero_area + report.few_corners);
        ASSERT_EQ(report.drawn, mesh.face_count());
        ASSERT_EQ(mesh.face_normals.size(), mesh.face_count());
        ASSERT_EQ(mesh.face_material.size(), mesh.face_count());
        ASSERT_TRUE(all_normals_are_unit(mesh));
        ASSERT_LE(report.split_faces, report.drawn);
    }
}

TEST(Build, EachCornerOfAFlatFaceLiesInItsPlane) {
    for (const char* name : {"cube", "cylinder:7", "star", "icosphere:1"}) {
        const Mesh mesh = build(shape(name)).mesh;
        ASSERT_EQ(mesh.face_offset.size(), mesh.face_count());
        for (std::size_t face = 0; face < mesh.face_count(); ++face) {
            for (const glm::vec3& corner : points_of_face(mesh, face))
                EXPECT_NEAR(glm::dot(mesh.face_normals[face], corner), mesh.face_offset[face], 1e-6)
                    << name;
        }
    }
}

TEST(Build, UAndVOfAFlatFaceAreLinearFunctionsOfThePoint) {
    const Mesh mesh = build(shape("sphere:12,6")).mesh;
    ASSERT_EQ(mesh.face_u.size(), mesh.face_count());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const auto corners = mesh.face(face);
        if (corners.size() != 3) continue;
        for (const std::uint32_t v : corners) {
            const glm::vec4 point(mesh.vertices.position(v), 1.0f);
            EXPECT_NEAR(glm::dot(mesh.face_u[face], point), mesh.vertices.u[v], 1e-5);
            EXPECT_NEAR(glm::dot(mesh.face_v[face], point), mesh.vertices.v[v], 1e-5);
        }
    }
}

TEST(Build, AnEmptySoupGivesAnEmptyMesh) {
    const auto [mesh, report] = build(PolygonSoup{});
    EXPECT_EQ(mesh.face_count(), 0u);
    EXPECT_EQ(mesh.materials.size(), 1u);
    EXPECT_FALSE(report.closed());
}

TEST(Build, PointsThatNoDrawnFaceUsesAreIsolated) {
    const auto [mesh, report] = build(
        soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 4}}));
    EXPECT_EQ(report.isolated_points, 2u);  // the last face has no area
    EXPECT_EQ(report.zero_area, 1u);
    EXPECT_EQ(mesh.vertices.size(), 3u);
}

TEST(Build, CornersInOneLineHaveNoAreaWhateverTheRounding) {
    // All on y = 3 x, but the differences from the first point are not doubles.
    const float tiny = 0x1p-53f;
    EXPECT_EQ(
        build(soup_of({{tiny, 3 * tiny, 0}, {1, 3, 0}, {2, 6, 0}}, {{0, 1, 2}})).report.zero_area,
        1u);
    EXPECT_EQ(build(soup_of({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}, {{0, 1, 2, 3}}))
                  .report.zero_area,
              1u);
}

TEST(Build, TheThinnestTriangleOfFloatsIsDrawn) {
    const float one_less = std::nextafter(1.0f, 0.0f);
    const auto [mesh, report] =
        build(soup_of({{0, 0, 0}, {1, one_less, 0}, {2, 2, 0}}, {{0, 1, 2}}));
    EXPECT_EQ(report.drawn, 1u);
    EXPECT_EQ(mesh.face_normals[0], glm::vec3(0, 0, 1));
}

TEST(Build, ABowTieWhoseAreasCancelIsDrawn) {
    const auto [mesh, report] =
        build(soup_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
    EXPECT_EQ(report.drawn, 1u);
    EXPECT_EQ(std::abs(mesh.face_normals[0].z), 1.0f);
}

TEST(Build, AClosedSolidIsClosedAndManifold) {
    const BuildReport report = build(soup_of(tetrahedron_points, tetrahedron_faces)).report;
    EXPECT_TRUE(report.closed());
    EXPECT_TRUE(report.manifold());
    EXPECT_EQ(report.edges, 6u);
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(report.euler_number(), 2);
}

TEST(Build, SolidsThatTouchInAPointKeepAllFacesInAnyOrder) {
    std::vector<glm::vec3> points = tetrahedron_points;
    points.insert(points.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    Faces faces = tetrahedron_faces;
    faces.insert(faces.end(), {{0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}});
    Dice dice(2);
    for (int round = 0; round < 200; ++round) {
        dice.shuffle(faces);
        const BuildReport report = build(soup_of(points, faces)).report;
        ASSERT_EQ(report.drawn, 8u);
        ASSERT_EQ(report.split_vertices, 1u);
        ASSERT_EQ(report.split_faces, 0u);
        ASSERT_EQ(report.components, 2u);
        ASSERT_TRUE(report.closed());
    }
}

TEST(Build, SolidsThatTouchInAnEdgeStayThemselvesInAnyOrder) {
    const PolygonSoup soup = two_cubes({1, 1, 0});
    std::vector<std::size_t> order(soup.face_count());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    Dice dice(3);
    for (int round = 0; round < 200; ++round) {
        dice.shuffle(order);
        const auto [mesh, report] = build(in_order(soup, order), {.crease_deg = 180});
        ASSERT_EQ(report.components, 2u);
        ASSERT_EQ(report.split_faces, 0u);
        ASSERT_EQ(report.split_vertices, 2u);
        ASSERT_TRUE(report.closed());
        for (std::size_t face = 0; face < mesh.face_count(); ++face) {
            const bool first = order[face] < 6;
            const glm::vec3 center = first ? glm::vec3(0.5f) : glm::vec3(1.5f, 1.5f, 0.5f);
            for (const std::uint32_t v : mesh.face(face)) {
                const glm::vec3 outward = glm::normalize(mesh.vertices.position(v) - center);
                ASSERT_LT(distance(mesh.vertices.normal(v), outward), 1e-6f);
            }
        }
    }
}

TEST(Build, SolidsThatShareAWallEachKeepTheirs) {
    const BuildReport report = build(two_cubes({1, 0, 0})).report;  // the wall is there twice
    EXPECT_EQ(report.drawn, 12u);
    EXPECT_EQ(report.components, 2u);
    EXPECT_EQ(report.split_faces, 0u);
    EXPECT_TRUE(report.closed());
}

TEST(Build, ARepeatedFaceStandsAloneAndLeavesTheSolidWhole) {
    for (const std::vector<Point>& repeat :
         {std::vector<Point>{1, 2, 3}, {2, 3, 1}, {3, 2, 1}, {1, 3, 2}}) {
        Faces faces = tetrahedron_faces;
        faces.push_back(repeat);
        const BuildReport report = build(soup_of(tetrahedron_points, faces)).report;
        EXPECT_EQ(report.drawn, 5u);
        EXPECT_EQ(report.split_faces, 1u);
        EXPECT_EQ(report.components, 2u);
        EXPECT_EQ(report.boundary_edges, 3u);
        EXPECT_EQ(report.split_vertices, 3u);
    }
}

TEST(Build, AThirdPageIsSplitOff) {
    const BuildReport report =
        build(soup_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}))
            .report;
    EXPECT_EQ(report.drawn, 3u);
    EXPECT_EQ(report.split_faces, 1u);
    EXPECT_EQ(report.edges, 8u);
}

TEST(Build, NeighboursOfOppositeOrientationAreSplit) {
    const auto [mesh, report] =
        build(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}));
    EXPECT_EQ(report.split_faces, 1u);
    EXPECT_EQ(report.components, 2u);
    EXPECT_EQ(mesh.vertices.normal(mesh.face(0)[0]), glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices.normal(mesh.face(1)[0]), glm::vec3(0, 0, -1));
}

TEST(Build, AMoebiusStripLosesNoFace) {
    std::vector<glm::vec3> points;
    Faces faces;
    constexpr Point n = 7;
    for (Point i = 0; i < n; ++i) {
        const double turn = 2 * 3.14159265358979 * i / n;
        for (const double side : {-0.3, 0.3}) {
            const double r = 1 + side * std::cos(turn / 2);
            points.emplace_back(r * std::cos(turn), r * std::sin(turn), side * std::sin(turn / 2));
        }
        const Point next = i + 1 == n ? 0 : i + 1;
        const Point flip = i + 1 == n ? 1 : 0;
        faces.push_back({2 * i, 2 * next + flip, 2 * next + 1 - flip, 2 * i + 1});
    }
    const auto [mesh, report] = build(soup_of(points, faces));
    EXPECT_EQ(report.drawn, n);
    EXPECT_EQ(report.components, 1u);
    EXPECT_GE(report.split_faces, 1u);
    EXPECT_TRUE(all_normals_are_unit(mesh));
}

TEST(Build, APolygonThatTouchesItselfGetsAPointTwice) {
    const BuildReport report =
        build(soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                      {{0, 1, 2, 0, 3, 4}}))
            .report;
    EXPECT_EQ(report.drawn, 1u);
    EXPECT_EQ(report.vertices, 6u);
    EXPECT_EQ(report.edges, 6u);
}

TEST(Build, APolygonWithABridgeToItsHoleIsDrawnWithItsNeighbours) {
    const std::vector<glm::vec3> points{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                        {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
    const BuildReport report =
        build(soup_of(points, {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, {4, 7, 6, 5}})).report;
    EXPECT_EQ(report.drawn, 2u);
    EXPECT_EQ(report.vertices, 8u + report.split_vertices);
}

TEST(Build, TenThousandPagesOnOneEdgeAreNoTrouble) {
    std::vector<glm::vec3> points{{0, 0, 0}, {0, 0, 1}};
    Faces faces;
    for (Point i = 0; i < 10000; ++i) {
        points.emplace_back(static_cast<float>(i) - 5000.5f, i % 7 + 1, 0);
        faces.push_back(i % 3 == 0 ? std::vector<Point>{1, 0, i + 2}
                                   : std::vector<Point>{0, 1, i + 2});
    }
    EXPECT_EQ(build(soup_of(points, faces)).report.drawn, 10000u);
}

TEST(Build, BadFacesAreCountedByTheirReason) {
    const BuildReport report =
        build(soup_of(tetrahedron_points,
                      {{0, 1, 2}, {}, {0}, {0, 1}, {0, 0, 1}, {0, 1, 0, 1}, {1, 1, 2, 2, 3, 3}}))
            .report;
    EXPECT_EQ(report.few_corners, 5u);
    EXPECT_EQ(report.drawn, 2u);
}

}  // namespace
}  // namespace scanlight::mesh
