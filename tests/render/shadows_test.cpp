#include "render/shadows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "tests/render/shadow_agreement.h"

namespace scanlight::render {
namespace {

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

/// What lets light through casts no shadow, if the model knows of it.
TEST(Shadows, AreNotCastByWhatLetsLightThrough) {
    Scene scene = chapter_scene({10.0, 5.0, 0.0}, {1.5, 0.0, 0.0});  // SVOL.a, in the shadow
    scene.objects.back().materials.front().transmission.diffuse = glm::vec3(0.5f);
    for (const Shadows method : {Shadows::zpass, Shadows::zfail}) {
        EXPECT_EQ(count_at_target(scene, method), 1);
        Settings settings;
        settings.illumination = shading::Illumination::hall;
        settings.shadows = method;
        const Drawing drawing = draw_depth(scene, settings, {1, 1});
        EXPECT_EQ(count_shadows(scene, settings, 0, drawing.framebuffer.depth).at(0, 0), 0);
    }
}

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

}  // namespace
}  // namespace scanlight::render
