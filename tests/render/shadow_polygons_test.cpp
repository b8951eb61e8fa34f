#include "render/shadow_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "render/draw_details.h"
#include "render/lit_share.h"
#include "tests/render/shadow_agreement.h"

namespace scanlight::render {
namespace {

/// Meshes that objects refer to, and the objects.
struct Stage {
    std::vector<std::unique_ptr<mesh::Mesh>> meshes;
    std::vector<Object> objects;

    void put(const std::vector<Corners>& polygons) {
        mesh::PolygonSoup soup;
        for (const Corners& polygon : polygons) {
            for (const glm::dvec3& corner : polygon) {
                soup.corners.push_back({static_cast<std::uint32_t>(soup.positions.size())});
                soup.positions.emplace_back(corner);
            }
            soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
        }
        meshes.push_back(std::make_unique<mesh::Mesh>(mesh::build(soup, {}).mesh));
        objects.push_back(object_of(*meshes.back()));
    }
};

Corners level_square(double half_side, double y) {
    return {{-half_side, y, half_side},
            {half_side, y, half_side},
            {half_side, y, -half_side},
            {-half_side, y, -half_side}};
}

/// Of a part of a face: its outlines and their holes turn either way round in one plane.
double detail_area(const DetailPolygon& detail) {
    glm::dvec3 sum(0.0);
    for (const Corners& outline : detail.outlines) {
        const OrientedPlane plane = plane_of(outline);
        sum += area_of(outline) * plane.normal;
    }
    return std::sqrt(glm::dot(sum, sum));
}

/// Of each face, by object and face.
using Areas = std::map<std::pair<std::size_t, std::size_t>, double>;

Areas areas_of(const std::vector<Object>& objects, const glm::dvec4& light, LightPart part) {
    Areas areas;
    for (const DetailPolygon& detail : detail_polygons(objects, light, part))
        areas[{detail.object, detail.face}] = detail_area(detail);
    return areas;
}

bool has_corner(const std::vector<DetailPolygon>& details, const glm::dvec3& expected) {
    return std::ranges::any_of(details, [&](const DetailPolygon& detail) {
        return std::ranges::any_of(detail.outlines, [&](const Corners& outline) {
            return std::ranges::any_of(outline, [&](const glm::dvec3& corner) {
                return glm::distance(corner, expected) < 1e-6;
            });
        });
    });
}

// ---- the chapter's example

const glm::dvec4 chapter_light(0.0, 10.0, 0.0, 1.0);

TEST(ShadowPolygons, SHAD_b_AreasOfTheChaptersFloor) {
    Stage stage;
    stage.put({level_square(5.0, 0.0)});
    stage.put({level_square(1.0, 5.0)});
    const Areas lit = areas_of(stage.objects, chapter_light, LightPart::lit);
    const Areas shadowed = areas_of(stage.objects, chapter_light, LightPart::shadowed);
    EXPECT_NEAR(lit.at({0, 0}), 84.0, 1e-6);
    EXPECT_NEAR(shadowed.at({0, 0}), 16.0, 1e-6);
    EXPECT_NEAR(lit.at({1, 0}), 4.0, 1e-12);  // the caster itself
    EXPECT_FALSE(shadowed.contains({1, 0}));
}

TEST(ShadowPolygons, SHAD_a_CornerOfTheShadowOnTheFloor) {
    Stage stage;
    stage.put({level_square(5.0, 0.0)});
    stage.put({level_square(1.0, 5.0)});
    for (const LightPart part : {LightPart::lit, LightPart::shadowed}) {
        const auto details = detail_polygons(stage.objects, chapter_light, part);
        for (const glm::dvec3& corner : level_square(2.0, 0.0))
            EXPECT_TRUE(has_corner(details, corner));
    }
}

TEST(ShadowPolygons, SHAD_d_CornerOfTheShadowOnTheWall) {
    Stage stage;
    stage.put({{{-20, -20, -3}, {20, -20, -3}, {20, 20, -3}, {-20, 20, -3}}});
    stage.put({{{-0.5, 5, -1}, {0.5, 5, -1}, {0.5, 5, 1}, {-0.5, 5, 1}}});
    EXPECT_TRUE(has_corner(detail_polygons(stage.objects, chapter_light), {1.5, -5.0, -3.0}));
}

// ---- hard cases

TEST(ShadowPolygons, OneThatGoesThroughAnotherIsCutThere) {
    Stage stage;
    stage.put({level_square(1.0, 0.0)});
    // Rises from y = -1 at x = -1 to y = 1 at x = 1.
    stage.put({{{-1, -1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, -1, -1}}});
    const Areas lit = areas_of(stage.objects, {0.0, 1.0, 0.0, 0.0}, LightPart::lit);
    EXPECT_NEAR(lit.at({0, 0}), 2.0, 1e-6);
    EXPECT_NEAR(lit.at({1, 0}), 2.0 * std::sqrt(2.0), 1e-6);
}

// Three planks, each over the next and under the one before, in a ring.
TEST(ShadowPolygons, InACycleEachShadowsTheNext) {
    Stage stage;
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2.0943951023931953;
        const glm::dvec3 along(std::cos(angle), 0.0, std::sin(angle));
        const glm::dvec3 across(-along.z, 0.0, along.x);
        const glm::dvec3 rise(0.0, 0.5, 0.0);
        const glm::dvec3 middle = -0.9 * across;
        stage.put({{middle - 2.0 * along - rise - 0.2 * across,
                    middle + 2.0 * along + rise - 0.2 * across,
                    middle + 2.0 * along + rise + 0.2 * across,
                    middle - 2.0 * along - rise + 0.2 * across}});
    }
    const glm::dvec4 light(0.0, 1.0, 0.0, 0.0);
    const Areas lit = areas_of(stage.objects, light, LightPart::lit);
    const Areas shadowed = areas_of(stage.objects, light, LightPart::shadowed);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(shadowed.contains({i, 0}));
        EXPECT_GT(shadowed.at({i, 0}), 0.1);
        EXPECT_NEAR(shadowed.at({i, 0}), shadowed.at({0, 0}), 1e-6);
        EXPECT_NEAR(lit.at({i, 0}) + shadowed.at({i, 0}), 4.0 * std::sqrt(17.0) * 0.1, 1e-6);
    }
}

TEST(ShadowPolygons, FacesInOnePlaneDoNotShadowOneAnother) {
    Stage stage;
    stage.put({level_square(2.0, 0.0)});
    stage.put({level_square(1.0, 0.0)});
    for (const DetailPolygon& detail : detail_polygons(stage.objects, chapter_light))
        EXPECT_TRUE(detail.whole);
    EXPECT_TRUE(detail_polygons(stage.objects, chapter_light, LightPart::shadowed).empty());
}

TEST(ShadowPolygons, AClosedConvexBodyIsLitOnOneSide) {
    const mesh::Mesh mesh = shape_mesh("icosphere:2");
    const std::vector<Object> objects{object_of(mesh)};
    const glm::dvec4 light(2.0, 3.0, 1.0, 1.0);
    const auto details = detail_polygons(objects, light);
    std::size_t turned_to = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 corner(mesh.vertices.position(mesh.face(f)[0]));
        turned_to += glm::dot(glm::dvec3(mesh.face_normals[f]), glm::dvec3(light) - corner) > 0.0;
    }
    EXPECT_EQ(details.size(), turned_to);
    for (const DetailPolygon& detail : details)
        EXPECT_TRUE(detail.whole);
}

TEST(ShadowPolygons, ALightInABodyLightsItsInside) {
    const mesh::Mesh mesh = shape_mesh("cube");
    const std::vector<Object> objects{object_of(mesh)};
    const glm::dvec4 light(0.2, 0.1, -0.3, 1.0);
    const auto details = detail_polygons(objects, light);
    EXPECT_EQ(details.size(), 6u);
    EXPECT_TRUE(detail_polygons(objects, light, LightPart::shadowed).empty());
}

// ---- laws

/// A convex polygon of three or four corners.
Corners random_polygon(Random& random) {
    const glm::dvec3 a = random.in_cube(2.0);
    const glm::dvec3 b = a + random.in_cube(1.5);
    const glm::dvec3 c = a + random.in_cube(1.5);
    return random.below(2) == 0 ? Corners{a, b, c} : Corners{a, b, b + (c - a), c};
}

glm::dvec4 random_light(Random& random) {
    return random.below(2) == 0 ? glm::dvec4(random.in_cube(4.0), 1.0)
                                : glm::dvec4(random.direction(), 0.0);
}

/// The sine of the least angle at which the light falls on a polygon, or about it.
double steepness(const Corners& polygon, const glm::dvec4& light) {
    const OrientedPlane plane = plane_of(polygon);
    const glm::dvec3 towards = glm::dvec3(light) - light.w * polygon[0];
    return std::abs(glm::dot(plane.normal, glm::normalize(towards)));
}

TEST(ShadowPolygons, LitAndShadowedPartsAddUpToEachFace) {
    int cut = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const RandomScene random = random_scene(seed, 2);
        const auto& objects = random.scene.objects;
        for (const auto& source : random.scene.lighting.lights) {
            const glm::dvec4 light = homogeneous(source);
            const Areas lit = areas_of(objects, light, LightPart::lit);
            const Areas shadowed = areas_of(objects, light, LightPart::shadowed);
            for (const FlatFace& face : flat_faces(objects, flatness(objects))) {
                // A face that the light grazes is a line on the grid.
                if (steepness(face.corners, light) < 1e-3) continue;
                const std::pair key{face.object, face.face};
                const double sum = (lit.contains(key) ? lit.at(key) : 0.0) +
                                   (shadowed.contains(key) ? shadowed.at(key) : 0.0);
                ASSERT_NEAR(sum, area_of(face.corners), 1e-4) << "seed " << seed;
                cut += lit.contains(key) && shadowed.contains(key);
            }
        }
    }
    EXPECT_GT(cut, 300);
}

TEST(ShadowPolygons, OnePolygonShadowsAnotherByTheAreaThatObjectSpaceFinds) {
    Random random(17);
    int shadowed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Corners receiver = random_polygon(random);
        const Corners caster = random_polygon(random);
        const glm::dvec4 light = random_light(random);
        if (steepness(receiver, light) < 0.05 || steepness(caster, light) < 0.01) continue;
        Stage stage;
        stage.put({receiver});
        stage.put({caster});
        const auto faces = flat_faces(stage.objects, flatness(stage.objects));
        double expected = 0.0;  // of the shadows of the part of the caster before the receiver
        const FaceShadow shadow(faces[1].corners, light);
        const auto parts = shadow.cut(faces[0].corners);
        expected = parts.shadowed.empty() ? 0.0 : area_of(parts.shadowed);
        const Areas areas = areas_of(stage.objects, light, LightPart::shadowed);
        const double found = areas.contains({0, 0}) ? areas.at({0, 0}) : 0.0;
        ASSERT_NEAR(found, expected, 1e-5) << i;
        shadowed += found > 0.01;
    }
    EXPECT_GT(shadowed, 100);
}

// ---- agreement with shadow volumes, pixel by pixel

/// Pixels away from the edges of umbras: within one face, and at the edge of another.
struct Comparison {
    int within = 0;
    int at_edges = 0;
    int shadowed = 0;
    int different_within = 0;
    int different_at_edges = 0;
};

void compare_with_zfail(const Scene& scene, std::size_t light, Comparison& all) {
    constexpr raster::Viewport viewport{63, 47};
    const auto depth = draw_depth(scene, {}, viewport).framebuffer.depth;
    const auto items = draw_items(scene, {}, viewport);
    Settings settings;
    settings.shadows = Shadows::zfail;
    const auto expected = lit_share(scene, settings, light, depth);
    settings.shadows = Shadows::polygons;
    const auto found = lit_share(scene, settings, light, depth);
    for_each_pixel(viewport, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear || !is_even(expected, x, y)) return;
        const bool within = is_even(items, x, y);
        const int off = found.at(x, y) != expected.at(x, y) ? 1 : 0;
        ++(within ? all.within : all.at_edges);
        (within ? all.different_within : all.different_at_edges) += off;
        all.shadowed += expected.at(x, y) == 0.0f ? 1 : 0;
    });
}

// No seams along the edges of faces either: but for the few pixels that show a face which comes
// through another by less than a pixel, so that the umbra's edge is there.
TEST(ShadowPolygons, AgreeWithShadowVolumes) {
    Comparison all;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const RandomScene random = random_scene(seed, 3);
        for (std::size_t light = 0; light < random.scene.lighting.lights.size(); ++light)
            compare_with_zfail(random.scene, light, all);
    }
    EXPECT_EQ(all.different_within, 0);
    EXPECT_LT(all.different_at_edges, 10);
    EXPECT_GT(all.within, 100'000);
    EXPECT_GT(all.at_edges, 20'000);
    EXPECT_GT(all.shadowed, 10'000);
}

}  // namespace
}  // namespace scanlight::render
