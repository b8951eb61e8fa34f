#include <gtest/gtest.h>

#include <memory>

#include "render/room.h"
#include "shading/refraction.h"
#include "shading/whitted.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

using V = glm::dvec3;
constexpr raster::Viewport size{80, 60};
constexpr double mirror = 0.3;
constexpr double refracted = 0.6;

/// A ball that has no light of its own to show.
Scene ball_in_a_room(const mesh::Mesh& ball, double eta) {
    shading::Material<float> material{};
    material.ambient = material.diffuse = glm::vec3(0.0f);
    material.mirror = glm::vec3(static_cast<float>(mirror));
    material.refracted = glm::vec3(static_cast<float>(refracted));
    material.transmission.eta = eta;
    Scene scene = scene_of(std::vector{object_of(ball, material)}, {{}, size});
    scene.lighting = {};
    scene.mirrored = std::make_shared<const shading::Environment>(
        shading::Environment{shading::EnvironmentLayout::latitudes, {room(256)}, glm::mat3(1.0f)});
    return scene;
}

/// Whitted's model with what arrives from the room along S and T, from the chapter's formulas.
V expected(const shading::Environment& room, const V& N, const V& view, double eta) {
    const auto arriving = [&](const V& d) { return shading::light_from<double>(room, d); };
    const V S = shading::reflected(view, N);
    const V T = shading::refracted(view, N, eta);
    const V nothing(0.0);
    if (T == nothing)
        return shading::whitted_at_total_reflection(nothing, arriving(S), V(mirror), V(refracted));
    return shading::whitted(nothing, arriving(S), V(mirror), arriving(T), V(refracted));
}

/// How many pixels the ball covers, how many are not as expected, how many reflect totally. Borders
/// within the room are sharp: there float and double may fall on two sides.
struct Found {
    int shown = 0;
    int different = 0;
    int total = 0;
};

Found compared(double eta) {
    const mesh::Mesh ball = shape_mesh("sphere:96,48");
    const Scene scene = ball_in_a_room(ball, eta);
    const Drawing drawing = draw(scene, {}, size);
    const auto normals = draw_normals(scene, {}, size);
    const Frame frame = frame_of(scene, Distances::finite, size);
    Found found;
    for_each_pixel(size, [&](int x, int y) {
        const auto depth = drawing.framebuffer.depth.at(x, y);
        if (depth == raster::depth_clear) return;
        ++found.shown;
        const V N = glm::normalize(V(normals.at(x, y)));
        const V view(frame.view_from(frame.point_at(x, y, depth)));
        const V color = expected(*scene.mirrored, N, view, eta);
        const V drawn(glm::vec3(drawing.framebuffer.color.at(x, y)));
        found.different += glm::distance(color, drawn) > 2e-3 ? 1 : 0;
        found.total += shading::refracted(view, N, eta) == V(0.0) ? 1 : 0;
    });
    return found;
}

TEST(Environment, WHIT_IsMirroredAndSeenThroughASurface) {
    for (const double eta : {1.0, 1.333, 1.5}) {
        const Found found = compared(eta);
        EXPECT_GT(found.shown, 500);
        EXPECT_LE(100 * found.different, found.shown) << eta;
        EXPECT_EQ(found.total, 0);
    }
}

TEST(Environment, WHIT_IsMirroredAltogetherWhereLightCannotEnter) {
    const Found found = compared(0.75);
    EXPECT_LE(100 * found.different, found.shown);
    EXPECT_GT(found.total, 100);
}

}  // namespace
}  // namespace scanlight::render
