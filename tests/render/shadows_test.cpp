#include "render/shadows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "render/face_shadow.h"
#include "render/shadow_volume.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

using Counts = raster::Plane<std::int32_t>;

// ---- the chapter's example: a square, 2 wide, 5 above the floor, a light 10 above it

const mesh::Mesh& square() {
    static const mesh::Mesh mesh = shape_mesh("plane:1");
    return mesh;
}

Object scaled_square(double half_side, double y) {
    Object object{&square(), shading_materials(square().materials)};
    object.world_from_object[0][0] = half_side;
    object.world_from_object[2][2] = half_side;
    object.world_from_object[3][1] = y;
    return object;
}

Scene chapter_scene(const glm::dvec3& eye, const glm::dvec3& target) {
    Scene scene;
    scene.objects = {scaled_square(10.0, 0.0), scaled_square(1.0, 5.0)};
    scene.camera.eye = eye;
    scene.camera.target = target;
    scene.lighting.lights = {shading::point_light<float>({0.0f, 10.0f, 0.0f}, glm::vec3(1.0f))};
    return scene;
}

/// At the only pixel's centre, which the target is.
std::int32_t count_at_target(const Scene& scene, Shadows method) {
    Settings settings;
    settings.shadows = method;
    const Drawing drawing = draw_depth(scene, settings, {1, 1});
    return count_shadows(scene, settings, 0, drawing.framebuffer.depth).at(0, 0);
}

struct CountExample {
    const char* id;
    glm::dvec3 eye, point;
    int zpass, zfail;
};

class ShadowCountOracle : public testing::TestWithParam<CountExample> {};

TEST_P(ShadowCountOracle, Agrees) {
    const auto& [id, eye, point, zpass, zfail] = GetParam();
    const Scene scene = chapter_scene(eye, point);
    EXPECT_EQ(count_at_target(scene, Shadows::zpass_from_zero), zpass) << id;
    EXPECT_EQ(count_at_target(scene, Shadows::zfail), zfail) << id;
    EXPECT_EQ(count_at_target(scene, Shadows::zpass), zfail) << id;  // with its beginning
}

INSTANTIATE_TEST_SUITE_P(Chapter, ShadowCountOracle,
                         testing::Values(CountExample{"SVOL.a", {10, 5, 0}, {1.5, 0, 0}, 1, 1},
                                         CountExample{"SVOL.b", {10, 5, 0}, {-6, 0, 0}, 0, 0},
                                         CountExample{"SVOL.c", {10, 5, 0}, {4, 0, 0}, 0, 0},
                                         CountExample{"SVOL.d", {0, 2, 0}, {1.5, 0, 0}, 0, 1},
                                         CountExample{"SVOL.e", {0, 2, 0}, {5, 0, 0}, -1, 0}));

// ---- agreement of the methods on random scenes

/// Closed casters over a floor, some touching or cutting it, and up to `most_lights` lights.
struct RandomScene {
    std::vector<mesh::Mesh> meshes;
    Scene scene;
};

RandomScene random_scene(std::uint32_t seed, int most_lights) {
    Random random(seed);
    const char* shapes[] = {"cube", "tetrahedron", "sphere:7,5", "torus:8,5", "octahedron"};
    RandomScene result;
    const int casters = 1 + random.below(4);
    for (int i = 0; i < casters; ++i)
        result.meshes.push_back(shape_mesh(shapes[random.below(5)]));
    result.meshes.push_back(shape_mesh("plane:2"));
    for (const mesh::Mesh& mesh : result.meshes) {
        Object object{&mesh, shading_materials(mesh.materials)};
        const bool is_floor = &mesh == &result.meshes.back();
        const double scale = is_floor ? 5.0 : random.between(0.2, 0.9);
        const glm::dvec3 place = is_floor ? glm::dvec3(0.0, -1.0, 0.0) : random.in_cube(1.5);
        for (int k = 0; k < 3; ++k)
            object.world_from_object[k][k] = scale;
        object.world_from_object[3] = glm::dvec4(place, 1.0);
        result.scene.objects.push_back(object);
    }
    const int lights = 1 + random.below(most_lights);
    for (int i = 0; i < lights; ++i) {
        const bool is_point = random.below(2) == 0;
        const glm::vec3 place(random.in_cube(is_point ? 3.0 : 1.0) + glm::dvec3(0.0, 1.5, 0.0));
        result.scene.lighting.lights.push_back(
            is_point ? shading::point_light<float>(place, glm::vec3(0.5f))
                     : shading::directional_light<float>(place, glm::vec3(0.5f)));
    }
    Camera& camera = result.scene.camera;
    camera.target = random.in_cube(0.5);
    camera.eye = camera.target + random.between(1.0, 8.0) * random.direction();
    camera.near = 0.05;
    camera.far = random.below(2) == 0 ? 50.0 : 6.0;  // some things lie beyond
    camera.projection = random.below(4) == 0 ? Projection::orthographic : Projection::perspective;
    if (camera.projection == Projection::orthographic) camera.magnification = 0.3;
    return result;
}

Counts counts_of(const Scene& scene, Shadows method, std::size_t light,
                 const raster::Plane<raster::Depth>& depth) {
    Settings settings;
    settings.shadows = method;
    return count_shadows(scene, settings, light, depth);
}

int difference(const Counts& a, const Counts& b) {
    int pixels = 0;
    for_each_pixel({a.width(), a.height()},
                   [&](int x, int y) { pixels += a.at(x, y) != b.at(x, y) ? 1 : 0; });
    return pixels;
}

TEST(Shadows, CountTheSameFromTheEyeAndFromInfinity) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const RandomScene random = random_scene(seed, 8);
        const Scene& scene = random.scene;
        const Drawing drawing = draw_depth(scene, {}, {63, 47});
        for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
            const auto& depth = drawing.framebuffer.depth;
            const Counts zfail = counts_of(scene, Shadows::zfail, i, depth);
            const Counts zpass = counts_of(scene, Shadows::zpass, i, depth);
            ASSERT_EQ(difference(zfail, zpass), 0) << "seed " << seed << ", light " << i;
        }
    }
}

constexpr double tolerance = 1e-3;  // of a point that is known by its depth

/// Whether each pixel's point is in shadow by the object-space test.
raster::Plane<std::uint8_t> object_space_shadows(const Scene& scene, std::size_t light,
                                                 const raster::Plane<raster::Depth>& depth) {
    const raster::Viewport viewport{depth.width(), depth.height()};
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    const auto shadows = face_shadows(scene.objects, homogeneous(scene.lighting.lights[light]));
    raster::Plane<std::uint8_t> result(viewport, 0);
    for_each_pixel(viewport, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear) return;
        const glm::dvec3 point(frame.point_at(x, y, depth.at(x, y)));
        const glm::dvec3 before = point + glm::dvec3(frame.view_from(point));
        result.at(x, y) = std::ranges::any_of(shadows, [&](const FaceShadow& shadow) {
            // A face that is seen from behind shadows itself.
            return shadow.contains(point, tolerance) ||
                   (shadow.contains(point, -tolerance) &&
                    shadow.behind(before) > shadow.behind(point));
        });
    });
    return result;
}

/// Whether a pixel, not at the border, and all its neighbours have one value.
bool is_even(const raster::Plane<std::uint8_t>& plane, int x, int y) {
    if (x == 0 || y == 0 || x == plane.width() - 1 || y == plane.height() - 1) return false;
    for (int j = y - 1; j <= y + 1; ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
            if (plane.at(i, j) != plane.at(x, y)) return false;
        }
    }
    return true;
}

/// How the counts agree with the object-space test, away from the shadows' edges.
struct Agreement {
    int compared = 0;
    int shadowed = 0;
    int different = 0;

    Agreement& operator+=(const Agreement& other) {
        compared += other.compared;
        shadowed += other.shadowed;
        different += other.different;
        return *this;
    }
};

Agreement agreement(const Scene& scene, Shadows method, std::size_t light,
                    raster::Viewport viewport = {63, 47}, double most_y = 1e30) {
    const Drawing drawing = draw_depth(scene, {}, viewport);
    const auto& depth = drawing.framebuffer.depth;
    const auto expected = object_space_shadows(scene, light, depth);
    const Counts counts = counts_of(scene, method, light, depth);
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    Agreement result;
    for_each_pixel(viewport, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear || !is_even(expected, x, y)) return;
        if (frame.point_at(x, y, depth.at(x, y)).y > most_y) return;
        ++result.compared;
        result.shadowed += expected.at(x, y);
        result.different += (counts.at(x, y) != 0) != (expected.at(x, y) != 0) ? 1 : 0;
    });
    return result;
}

TEST(Shadows, AreWhereTheObjectSpaceTestFindsThem) {
    Agreement all;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const RandomScene random = random_scene(seed, 2);
        for (std::size_t light = 0; light < random.scene.lighting.lights.size(); ++light) {
            const Agreement one = agreement(random.scene, Shadows::zfail, light);
            ASSERT_EQ(one.different, 0) << "seed " << seed << ", light " << light;
            all += one;
        }
    }
    EXPECT_GT(all.compared, 100'000);
    EXPECT_GT(all.shadowed, 10'000);
}

// ---- hard cases

/// Casters over a floor 2 below the origin, under a lamp, seen from the side.
class HardCase : public testing::Test {
protected:
    explicit HardCase() {
        scene_.camera.eye = {5.0, 3.0, 6.0};
        scene_.camera.target = {0.0, -1.0, 0.0};
        scene_.camera.magnification = 1.5;
        put("plane:3", 4.0, {0.0, -2.0, 0.0});
        light({0.5, 4.0, 0.7});
    }

    void put(const char* shape, double scale, const glm::dvec3& place) {
        put(std::make_unique<mesh::Mesh>(shape_mesh(shape)), scale, place);
    }
    void put(std::unique_ptr<mesh::Mesh> mesh, double scale, const glm::dvec3& place) {
        Object object{mesh.get(), shading_materials(mesh->materials)};
        for (int k = 0; k < 3; ++k)
            object.world_from_object[k][k] = scale;
        object.world_from_object[3] = glm::dvec4(place, 1.0);
        scene_.objects.push_back(object);
        meshes_.push_back(std::move(mesh));
    }
    void light(const glm::vec3& place) {
        scene_.lighting.lights = {shading::point_light<float>(place, glm::vec3(1.0f))};
    }

    /// By both methods, against the object-space test and against one another.
    void expect_agreement(int shadowed_at_least, double most_y = 1e30) const {
        for (const Shadows method : {Shadows::zpass, Shadows::zfail}) {
            const Agreement result = agreement(scene_, method, 0, {159, 119}, most_y);
            EXPECT_EQ(result.different, 0);
            EXPECT_GE(result.shadowed, shadowed_at_least);
            EXPECT_GT(result.compared, 1000);
        }
        const Drawing drawing = draw_depth(scene_, {}, {159, 119});
        const auto& depth = drawing.framebuffer.depth;
        EXPECT_EQ(difference(counts_of(scene_, Shadows::zpass, 0, depth),
                             counts_of(scene_, Shadows::zfail, 0, depth)),
                  0);
    }

    std::vector<std::unique_ptr<mesh::Mesh>> meshes_;
    Scene scene_;
};

using ShadowHardCase = HardCase;

TEST_F(ShadowHardCase, TheEyeInAShadow) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.eye = {-0.2, -1.2, 0.0};
    scene_.camera.target = {3.0, -2.0, 2.0};
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheNearPlaneCutsAShadow) {
    put("sphere:9,6", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.near = 6.5;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheNearPlaneCutsTheCaster) {
    put("sphere:9,6", 1.0, {0.0, 0.0, 0.0});
    scene_.camera.near = 7.2;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheFarPlaneCutsTheCaster) {
    put("sphere:9,6", 1.0, {0.0, 0.0, 0.0});
    scene_.camera.far = 8.5;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheLightIsInsideTheMesh) {
    put("sphere:9,6", 1.0, {0.0, 1.0, 0.0});
    light({0.1, 1.1, 0.2});
    expect_agreement(4000);  // all is dark
}

TEST_F(ShadowHardCase, TheLightTouchesTheMesh) {
    put("cube", 1.0, {0.0, 0.0, 0.0});
    light({1.0, 1.0, 1.0});  // a corner
    expect_agreement(40);
}

// The face itself lies in the border of a shadow; no light falls on it either way.
TEST_F(ShadowHardCase, TheLightIsInAFacesPlane) {
    put("cube", 1.0, {0.0, 0.0, 0.0});
    light({1.0, 4.0, 0.5});
    expect_agreement(40, -1.9);
}

TEST_F(ShadowHardCase, AnOpenMesh) {
    put("plane:2", 0.8, {0.0, 0.5, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AnOpenMeshSeenFromItsBackByTheLight) {
    put("plane:2", 0.8, {0.0, 0.5, 0.0});
    scene_.objects.back().world_from_object[1][1] = -0.8;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AConcavePolygon) {
    put("star:5", 1.0, {0.0, 0.0, 0.0});
    scene_.objects.back().world_from_object[1] = {0.0, 0.5, 1.0, 0.0};
    expect_agreement(40);
}

// Three leaves on one spine, and one of them twice.
TEST_F(ShadowHardCase, ANonManifoldMesh) {
    mesh::PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0.3f, 0.5f}, {-1, 0.1f, 0.5f}, {0.2f, 1, 0.5f}};
    for (const std::uint32_t leaf : {2u, 3u, 4u, 4u}) {
        for (const std::uint32_t corner : {0u, 1u, leaf})
            soup.corners.push_back({corner});
        soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    put(std::make_unique<mesh::Mesh>(mesh::build(soup, {}).mesh), 1.5, {0.0, 0.0, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AMeshThatShadowsItself) {
    put("torus:13,9", 1.2, {0.0, 0.0, 0.0});
    light({3.0, 1.0, 0.7});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AMirroredMesh) {
    put("tetrahedron", 1.0, {0.0, 0.0, 0.0});
    scene_.objects.back().world_from_object[0][0] = -1.0;
    put("sphere:6,4", 0.6, {0.3, 0.5, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheCameraIsFarAway) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.eye *= 300.0;
    scene_.camera.magnification *= 300.0;
    scene_.camera.near = 2400.0;
    scene_.camera.far = 2600.0;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, ThreeHundredVolumesOverOneAnother) {
    for (int i = 0; i < 300; ++i)
        put("plane:1", 0.8, {0.0, 0.003 * i, 0.0});
    const Drawing drawing = draw_depth(scene_, {}, {159, 119});
    const auto& depth = drawing.framebuffer.depth;
    const Counts zfail = counts_of(scene_, Shadows::zfail, 0, depth);
    EXPECT_EQ(*std::ranges::max_element(zfail.values()), 300);
    EXPECT_EQ(difference(zfail, counts_of(scene_, Shadows::zpass, 0, depth)), 0);
}

// ---- the picture

raster::Plane<raster::Rgba> picture(const Scene& scene, const Settings& settings) {
    return draw(scene, settings, {159, 119}).framebuffer.color;
}

TEST_F(ShadowHardCase, ColoursAreThoseOfTheAmbientPictureOrOfTheUnshadowedOne) {
    put("torus:13,9", 1.2, {0.0, 0.0, 0.0});
    scene_.lighting.ambient = glm::vec3(0.2f, 0.25f, 0.3f);
    Scene ambient = scene_;
    ambient.lighting.lights.clear();
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Settings settings;
        settings.shading = shading;
        const auto dark = picture(ambient, settings);
        const auto lit = picture(scene_, settings);
        settings.shadows = Shadows::zfail;
        const auto shadowed = picture(scene_, settings);
        const Drawing drawing = draw_depth(scene_, {}, {159, 119});
        const Counts counts = counts_of(scene_, Shadows::zfail, 0, drawing.framebuffer.depth);
        int in_shadow = 0;
        for_each_pixel({159, 119}, [&](int x, int y) {
            in_shadow += counts.at(x, y) != 0 ? 1 : 0;
            if (counts.at(x, y) != 0) {
                EXPECT_EQ(shadowed.at(x, y), dark.at(x, y));
            } else if (shading != Shading::gouraud) {
                EXPECT_EQ(shadowed.at(x, y), lit.at(x, y));
            } else {  // its intensities are interpolated apart
                EXPECT_NEAR(shadowed.at(x, y).r, lit.at(x, y).r, 1e-6f);
            }
        });
        EXPECT_GT(in_shadow, 1000);
    }
}

TEST_F(ShadowHardCase, EachLightHasShadowsOfItsOwn) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.lighting.lights.push_back(
        shading::directional_light<float>({-1.0f, 1.0f, 0.2f}, glm::vec3(0.3f)));
    Settings settings;
    settings.shadows = Shadows::zfail;
    const auto both = picture(scene_, settings);
    Scene first = scene_;
    first.lighting.lights.pop_back();
    Scene second = scene_;
    second.lighting = {glm::vec3(0.0f), {scene_.lighting.lights[1]}};
    second.background = raster::Rgba(0.0f);
    const auto a = picture(first, settings);
    const auto b = picture(second, settings);
    for_each_pixel({159, 119}, [&](int x, int y) {
        EXPECT_EQ(glm::vec3(both.at(x, y)), glm::vec3(a.at(x, y)) + glm::vec3(b.at(x, y)));
    });
}

}  // namespace
}  // namespace scanlight::render
