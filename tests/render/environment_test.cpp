#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "render/cube_map.h"
#include "render/light_view.h"
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

// ---- held against rays

/// Where a ray meets the sphere of radius 1 about the origin first; none where it passes by.
std::optional<V> hit_by(const V& eye, const V& direction) {
    const double half = glm::dot(eye, direction);
    const double inside = half * half - glm::dot(eye, eye) + 1.0;
    if (inside <= 0.0) return std::nullopt;
    return eye + direction * (-half - std::sqrt(inside));
}

TEST(Environment, ENV_IsWhatRaysBackFromATrueSphereMeet) {
    const mesh::Mesh ball = shape_mesh("sphere:512,256");
    Scene scene = ball_in_a_room(ball, 1.0);
    scene.objects.front().materials.front().refracted = glm::vec3(0.0f);
    const Drawing drawing = draw(scene, {}, size);
    const Frame frame = frame_of(scene, Distances::finite, size);
    const V eye = scene.camera.eye;
    int hits = 0;
    int different = 0;
    for_each_pixel(size, [&](int x, int y) {
        const V far = point_behind(frame.world_from_screen, V(x + 0.5, y + 0.5, 1.0));
        const V direction = glm::normalize(far - eye);
        const auto hit = hit_by(eye, direction);
        if (!hit || drawing.framebuffer.depth.at(x, y) == raster::depth_clear) return;
        const V S = direction - *hit * (2.0 * glm::dot(direction, *hit));
        const V met = shading::light_from<double>(*scene.mirrored, S) * mirror;
        const V drawn(glm::vec3(drawing.framebuffer.color.at(x, y)));
        ++hits;
        different += glm::distance(met, drawn) > 4e-3 ? 1 : 0;
    });
    EXPECT_GT(hits, 500);
    EXPECT_LE(100 * different, 3 * hits) << different << " of " << hits;
}

// ---- drawn by the rasterizer

/// Six balls, each of its own colour, 5 from the origin along the axes, and one that mirrors at it.
class SixBalls : public testing::Test {
protected:
    SixBalls() {
        for (int face = 0; face < 6; ++face)
            add(colors[face], 5.0 * axis(face)).ambient = colors[face];
        auto& mirroring = add(glm::vec3(0.0f), glm::dvec3(0.0));
        mirroring.mirror = glm::vec3(1.0f);
        scene.lighting = {glm::vec3(1.0f), {}};
        scene.background = raster::Rgba(0.25f, 0.25f, 0.25f, 1.0f);
    }

    static glm::dvec3 axis(int face) {
        glm::dvec3 d(0.0);
        d[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
        return d;
    }

    shading::Material<float>& add(const glm::vec3& color, const glm::dvec3& place) {
        shading::Material<float> material{};
        material.ambient = color;
        material.diffuse = glm::vec3(0.0f);
        scene.objects.push_back(object_of(ball, material));
        scene.objects.back().world_from_object[3] = glm::dvec4(place, 1.0);
        return scene.objects.back().materials.front();
    }

    static constexpr glm::vec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                           {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    mesh::Mesh ball = shape_mesh("sphere:64,32");
    Scene scene;
};

/// A ball of radius 1, 5 away, is seen within asin(1/5) = 11.5 degrees of its middle. A texel is
/// 0.9 degrees wide there, and a place shows something of those around it.
TEST_F(SixBalls, AreSeenWhereTheyAre) {
    const auto environment = cube_map(scene, {}, glm::dvec3(0.0), 128);
    Random random(4);
    int balls = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 d = random.direction();
        const glm::dvec3 light = shading::light_from<double>(environment, d);
        const auto face = static_cast<int>(cube_face(d));
        const double cosine = glm::dot(d, axis(face));
        if (cosine > 0.985) {  // 9.9 degrees
            ++balls;
            EXPECT_EQ(light, glm::dvec3(colors[face]));
        } else if (cosine < 0.974) {  // 13.1 degrees
            EXPECT_EQ(light, glm::dvec3(0.25));
        }
    }
    EXPECT_GT(balls, 150);
}

TEST_F(SixBalls, AreMirroredInTheMiddleOne) {
    scene.mirrored =
        std::make_shared<const shading::Environment>(cube_map(scene, {}, glm::dvec3(0.0), 128));
    scene.camera.eye = {0.0, 0.0, 4.0};  // before the ball at +z, which is behind it
    scene.camera.far = 6.0;
    const Drawing drawing = draw(scene, {}, {129, 129});
    const glm::dvec3 middle(glm::vec3(drawing.framebuffer.color.at(64, 64)));
    EXPECT_EQ(middle, glm::dvec3(colors[4]));
}

}  // namespace
}  // namespace scanlight::render
