// Laws of flat, Gouraud and Phong shading in whole pictures (specification 12.1.3).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/gouraud.h"
#include "shading/perception.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{64, 48};

raster::Plane<raster::Rgba> picture(const Scene& scene, const Settings& settings) {
    return draw(scene, settings, size).framebuffer.color;
}

Settings shaded(Shading shading) {
    Settings settings;
    settings.shading = shading;
    return settings;
}

TEST(ShadingLaws, AffineAndCorrectAreOneForAParallelCamera) {
    const auto mesh = shape_mesh("teapot:3");
    const Scene scene = scene_of(mesh, {{30.0, 20.0}, size, Projection::orthographic});
    for (const Shading shading : all_shadings) {
        Settings correct = shaded(shading);
        Settings affine = correct;
        affine.perspective = Perspective::affine;
        EXPECT_EQ(picture(scene, correct), picture(scene, affine));
    }
}

TEST(ShadingLaws, AffineAndCorrectDifferInPerspective) {
    const auto mesh = shape_mesh("plane:1");
    Scene scene = scene_of(mesh, {{10.0, 15.0}, size});
    scene.lighting.lights = {shading::point_light<float>({0.0f, 0.4f, 0.9f}, glm::vec3(1.0f))};
    Settings correct = shaded(Shading::gouraud);
    Settings affine = correct;
    affine.perspective = Perspective::affine;
    EXPECT_GT(largest_difference(picture(scene, correct), picture(scene, affine)), 0.01f);
}

TEST(ShadingLaws, TriangulationChangesNothingForTriangles) {
    for (const auto* shape : {"icosphere:2", "tetrahedron"}) {
        const auto mesh = shape_mesh(shape);
        const auto cut = mesh::triangulated(mesh);
        for (const Shading shading : all_shadings) {
            EXPECT_EQ(picture(scene_of(mesh, {{}, size}), shaded(shading)),
                      picture(scene_of(cut, {{}, size}), shaded(shading)));
        }
    }
}

TEST(ShadingLaws, TriangulationKeepsThePixelsOfQuads) {
    const auto mesh = shape_mesh("torus:8,5");
    const auto cut = mesh::triangulated(mesh);
    const auto whole = draw(scene_of(mesh, {{20.0, 40.0}, size}), shaded(Shading::flat), size);
    const auto parts = draw(scene_of(cut, {{20.0, 40.0}, size}), shaded(Shading::flat), size);
    EXPECT_EQ(covered_pixels(whole.framebuffer.depth), covered_pixels(parts.framebuffer.depth));
    EXPECT_NE(picture(scene_of(mesh, {{20.0, 40.0}, size}), shaded(Shading::gouraud)),
              picture(scene_of(cut, {{20.0, 40.0}, size}), shaded(Shading::gouraud)));
}

/// One triangle that fills most of the picture, its corners at very different distances.
mesh::Mesh slanted_triangle() {
    mesh::PolygonSoup soup;
    soup.positions = {{-1.0f, -1.0f, 1.5f}, {1.0f, -0.8f, 0.0f}, {0.2f, 1.0f, -2.0f}};
    soup.normals = {{-0.6f, 0.0f, 0.8f}, {0.6f, 0.0f, 0.8f}, {0.0f, 0.6f, 0.8f}};
    soup.corners = {{0, 0}, {1, 1}, {2, 2}};
    soup.face_begin = {0, 3};
    return mesh::build(soup, {mesh::NormalWeight::file}).mesh;
}

/// The shares of a triangle's corners in a point of its plane.
glm::dvec3 barycentric(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p) {
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double area = glm::dot(n, n);
    return {glm::dot(glm::cross(t[2] - t[1], p - t[1]), n) / area,
            glm::dot(glm::cross(t[0] - t[2], p - t[2]), n) / area,
            glm::dot(glm::cross(t[1] - t[0], p - t[0]), n) / area};
}

// C12.1.3-GOURAUD: at the vertices the vertices' intensities, and what is even between them: over
// the object when correct, over the screen when affine.
TEST(ShadingLaws, GouraudMixesTheVertexIntensities) {
    const auto mesh = slanted_triangle();
    const Scene scene = scene_of(mesh, {{10.0, 5.0}, size});
    const Frame frame = frame_of(scene, Distances::finite, size);
    for (const Perspective perspective : {Perspective::correct, Perspective::affine}) {
        Settings settings = shaded(Shading::gouraud);
        settings.perspective = perspective;
        const auto colors =
            illuminate_vertices(placed(scene.objects[0], frame), frame, settings, Side::front);
        const auto drawing = draw(scene, settings, size);
        std::array<glm::dvec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = mesh.vertices.position(i);
            if (perspective == Perspective::affine) {
                corners[i] = screen_from_world(scene.camera, size, corners[i]);
                corners[i].z = 0.0;
            }
        }
        std::size_t compared = 0;
        for_each_pixel(size, [&](int x, int y) {
            const auto depth = drawing.framebuffer.depth.at(x, y);
            if (depth == raster::depth_clear) return;
            const glm::dvec3 p = perspective == Perspective::affine
                                     ? glm::dvec3(x + 0.5, y + 0.5, 0.0)
                                     : glm::dvec3(frame.point_at(x, y, depth));
            const glm::dvec3 share = barycentric(corners, p);
            const glm::dvec3 expected = share.x * glm::dvec3(colors[0]) +
                                        share.y * glm::dvec3(colors[1]) +
                                        share.z * glm::dvec3(colors[2]);
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(drawing.framebuffer.color.at(x, y)[k], expected[k], 1e-3);
            ++compared;
        });
        EXPECT_GT(compared, 300u);
    }
}

/// A square of 2 x 2 that faces the camera, under one light of an intensity.
Scene flat_lit_plane(const mesh::Mesh& mesh, float intensity) {
    Scene scene = scene_of(mesh, {{0.0, 60.0}, size});
    scene.lighting = {glm::vec3(0.0f),
                      {shading::directional_light<float>(glm::vec3(0.3f, 1.0f, 0.2f),
                                                         glm::vec3(intensity, 1.0f, 0.01f))}};
    return scene;
}

TEST(ShadingLaws, GouraudEqualsFlatOnAFlatLitPlaneHoweverBrightTheLight) {
    const auto mesh = shape_mesh("plane:3");
    for (const float intensity : {1.0f, 3.9f, 4.1f, 100.0f, 1e6f, 1e30f}) {
        const Scene scene = flat_lit_plane(mesh, intensity);
        Settings settings;
        settings.illumination = shading::Illumination::lambert;
        settings.shading = Shading::flat;
        const auto flat = draw(scene, settings, size).framebuffer.color;
        settings.shading = Shading::gouraud;
        const auto gouraud = draw(scene, settings, size).framebuffer.color;
        float brightest = 0.0f;
        for_each_pixel(size, [&](int x, int y) {
            const float expected = flat.at(x, y).r;
            ASSERT_NEAR(gouraud.at(x, y).r, expected, 1e-5f * expected);
            brightest = std::max(brightest, expected);
        });
        EXPECT_GT(brightest, 0.4f * intensity);
    }
}

TEST(ShadingLaws, IntensitiesThatFitAreInterpolatedAsTheyAre) {
    const auto mesh = shape_mesh("plane:3");
    const auto unit_of = [&mesh](float intensity) {
        const Scene scene = flat_lit_plane(mesh, intensity);
        const Frame frame = frame_of(scene, Distances::finite, size);
        return vertex_intensities(placed(scene.objects[0], frame), frame, {}).unit;
    };
    EXPECT_EQ(unit_of(0.5f), 1.0f);
    EXPECT_EQ(unit_of(4.0f), 1.0f);  // a diffuse half of it arrives
    EXPECT_GT(unit_of(100.0f), 8.0f);
    EXPECT_LE(unit_of(100.0f), 32.0f);
}

/// The colour of the unit sphere at a pixel, by a ray of a parallel camera, in double.
glm::dvec3 analytic_sphere(const Scene& scene, const glm::dvec3& point) {
    const glm::dvec3 eye = glm::normalize(scene.camera.eye - scene.camera.target);
    const shading::Surface<double> surface{point, glm::normalize(point), eye};
    return illuminate<shading::Phong>(surface, plastic(), scene.lighting);
}

/// The mean error of Phong shading on a sphere of triangles against the true sphere, inside 0.9 of
/// its outline.
double sphere_error(int level) {
    const auto mesh = shape_mesh("icosphere:" + std::to_string(level), {.crease_deg = 180.0f});
    const Scene scene = scene_of(mesh, {{}, size, Projection::orthographic});
    const auto colors = picture(scene, shaded(Shading::phong));
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(eye_from_world(scene.camera)));
    const glm::dvec3 middle = screen_from_world(scene.camera, size, glm::dvec3(0.0));
    const double scale = 2.0 / (size.height * scene.camera.magnification);
    double sum = 0.0;
    int count = 0;
    for_each_pixel(size, [&](int px, int py) {
        const double x = (px + 0.5 - middle.x) * scale;
        const double y = -(py + 0.5 - middle.y) * scale;
        if (x * x + y * y > 0.81) return;
        const glm::dvec3 point = world_from_eye * glm::dvec3(x, y, std::sqrt(1.0 - x * x - y * y));
        const glm::dvec3 expected = analytic_sphere(scene, point);
        sum += glm::length(glm::dvec3(colors.at(px, py)) - expected);
        ++count;
    });
    EXPECT_GT(count, 500);
    return sum / count;
}

TEST(ShadingLaws, PhongShadingApproachesTheTrueSphere) {
    double error = sphere_error(1);
    EXPECT_GT(error, 1e-3);
    for (int level = 2; level <= 5; ++level) {
        const double finer = sphere_error(level);
        EXPECT_LT(finer, 0.5 * error) << "level " << level;
        error = finer;
    }
    EXPECT_LT(error, 2e-4);
}

TEST(ShadingLaws, PhongFindsTheHighlightThatGouraudLoses) {
    const auto mesh = shape_mesh("icosphere:1");
    Scene scene = scene_of(mesh, {{30.0, 20.0}, size});
    scene.objects[0].materials[0].specular = glm::vec3(0.9f);
    scene.objects[0].materials[0].exponent = 200.0;
    const auto brightest = [&](Shading shading) {
        float best = 0.0f;
        const auto colors = picture(scene, shaded(shading));
        for (const auto& color : colors.values())
            best = std::max(best, color.b);
        return best;
    };
    EXPECT_GT(brightest(Shading::phong), brightest(Shading::gouraud) + 0.3f);
}

// ---- Mach bands

/// The picture's middle row across a cylinder of 24 facets whose light comes from the eye.
std::vector<float> profile_of_a_cylinder(Shading shading) {
    constexpr raster::Viewport wide{321, 241};
    const auto mesh = shape_mesh("cylinder:24");
    Scene scene = scene_of(mesh, {{0.0, 0.0}, wide, Projection::orthographic});
    const shading::Material<float> white{glm::vec3(0.0f), glm::vec3(1.0f), glm::vec3(0.0f), 1.0};
    scene.objects.front().materials.assign(mesh.materials.size(), white);
    scene.lighting = {glm::vec3(0.0f),
                      {shading::directional_light<float>({0, 0, 1}, glm::vec3(1.0f))}};
    const auto colors = draw(scene, shaded(shading), wide).framebuffer.color;
    std::vector<float> profile;
    for (int x = 0; x < wide.width; ++x) {
        const auto& color = colors.at(x, wide.height / 2);
        if (color.a != 0.0f) profile.push_back(color.r);
    }
    return profile;
}

// C12.1.3-MACH: the profile of flat shading is a stair, cos of 15 degrees more from facet to facet;
// the eye sees it go too far on either side of each step.
TEST(ShadingLaws, AFlatCylindersProfileHasStepsThatTheEyeOverdoes) {
    const std::vector<float> profile = profile_of_a_cylinder(Shading::flat);
    const std::vector<float> seen = shading::lateral_inhibition<float>(profile);
    int steps = 0;
    std::size_t begin = 0;  // of the facet
    for (std::size_t x = 1; x + 4 < profile.size(); ++x) {
        if (profile[x] == profile[x - 1]) continue;
        const double angle = std::acos(static_cast<double>(profile[x])) * 12 / std::numbers::pi;
        const double before =
            std::acos(static_cast<double>(profile[x - 1])) * 12 / std::numbers::pi;
        EXPECT_NEAR(std::abs(angle - before), 1.0, 1e-3) << x;
        const bool is_wide = x - begin > 4 && profile[x + 3] == profile[x];
        const float up = profile[x] > profile[x - 1] ? 1.0f : -1.0f;
        if (is_wide) {
            EXPECT_GT(up * (seen[x] - profile[x]), 0.0f) << x;
            EXPECT_LT(up * (seen[x - 1] - profile[x - 1]), 0.0f) << x;
            ++steps;
        }
        begin = x;
    }
    EXPECT_GE(steps, 6);
}

// ---- vertex colours

/// A square before the eye, red on its left and blue on its right.
mesh::Mesh painted_square() {
    mesh::PolygonSoup soup;
    soup.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    soup.colors = {{1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
    soup.corners = {{0}, {1}, {2}, {3}};
    soup.face_begin = {0, 4};
    return mesh::build(soup).mesh;
}

Scene white_square_scene(const mesh::Mesh& mesh, Projection projection) {
    const shading::Material<float> white{glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(0.0f), 1.0};
    Scene scene = scene_of(std::vector{object_of(mesh, white)}, {{0.0, 0.0}, size, projection});
    scene.lighting = {glm::vec3(0.25f),
                      {shading::directional_light<float>({0, 0, 1}, glm::vec3(0.5f))}};
    return scene;
}

TEST(VertexColors, RunAcrossThePolygonInGouraudAndPhong) {
    const auto mesh = painted_square();
    for (const Projection projection : all_projections) {
        const Scene scene = white_square_scene(mesh, projection);
        const double left = screen_from_world(scene.camera, size, {-1.0, 0.0, 0.0}).x;
        const double right = screen_from_world(scene.camera, size, {1.0, 0.0, 0.0}).x;
        for (const Shading shading : {Shading::gouraud, Shading::phong}) {
            const auto colors = picture(scene, shaded(shading));
            for_each_pixel(size, [&](int x, int y) {
                const auto& color = colors.at(x, y);
                if (color.a == 0.0f) return;
                const double along = (x + 0.5 - left) / (right - left);
                ASSERT_NEAR(color.r, 0.75 * (1.0 - along), 2e-3);
                ASSERT_NEAR(color.g, 0.0, 1e-6);
                ASSERT_NEAR(color.b, 0.75 * along, 2e-3);
            });
        }
    }
}

TEST(VertexColors, AreMeantOverAFlatPolygon) {
    const auto mesh = painted_square();
    const auto colors =
        picture(white_square_scene(mesh, Projection::perspective), shaded(Shading::flat));
    const auto& middle = colors.at(size.width / 2, size.height / 2);
    EXPECT_NEAR(middle.r, 0.375, 1e-6);
    EXPECT_NEAR(middle.b, 0.375, 1e-6);
    EXPECT_EQ(middle.g, 0.0f);
}

TEST(VertexColors, LeaveTheHighlightWhite) {
    const auto mesh = painted_square();
    for (const Shading shading : all_shadings) {
        Scene scene = white_square_scene(mesh, Projection::orthographic);
        scene.objects[0].materials[0].specular = glm::vec3(0.5f);
        const auto colors = picture(scene, shaded(shading));
        // Light, eye and normal are one: (R.V)^n = 1 everywhere.
        EXPECT_NEAR(colors.at(size.width / 2, size.height / 2).g, 0.25, 1e-6);
    }
}

}  // namespace
}  // namespace scanlight::render
