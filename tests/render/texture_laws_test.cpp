// Laws of textures in whole pictures (specification 12.4): a pixel shows the texture at its point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "mesh/bounds.h"
#include "render/texture_fit.h"
#include "shading/pattern.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{96, 72};

/// Under ambient light alone, of which the body sends all that the texture lets it.
Scene evenly_lit(const mesh::Mesh& mesh, const View& view, const shading::Texture& texture) {
    const shading::Material<float> white{glm::vec3(1.0f), glm::vec3(0.0f), glm::vec3(0.0f), 1.0};
    Scene scene = scene_of(std::vector{object_of(mesh, white)}, view);
    scene.lighting = {glm::vec3(1.0f), {}};
    shading::SurfaceTextures textures;
    textures.diffuse = texture;
    scene.objects.front().textures.assign(mesh.materials.size(), textures);
    return scene;
}

/// Calls `visit(x, y, point, color)` for each pixel that shows something.
template <class Visit>
void for_each_point(const Scene& scene, const Settings& settings, raster::Viewport viewport,
                    Visit&& visit) {
    const Drawing drawing = draw(scene, settings, viewport);
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    for_each_pixel(viewport, [&](int x, int y) {
        const auto depth = drawing.framebuffer.depth.at(x, y);
        if (depth == raster::depth_clear) return;
        visit(x, y, glm::dvec3(frame.point_at(x, y, depth)), drawing.framebuffer.color.at(x, y).r);
    });
}

/// An image whose texels are their own u, so that bilinear look-up gives u itself.
shading::Texture image_of_u() {
    constexpr int width = 64;
    std::vector<float> rgba;
    for (int i = 0; i < width; ++i) {
        for (const float channel : {1.0f, 1.0f, 1.0f, 0.0f})
            rgba.push_back(channel * (static_cast<float>(i) + 0.5f) / width + (1.0f - channel));
    }
    shading::Texture texture;
    texture.pattern = shading::Pattern::image;
    texture.image = std::make_shared<const shading::TexelImage>(width, 1, rgba);
    texture.filter = shading::Filter::bilinear;
    texture.wrap = shading::Wrap::clamp;
    return texture;
}

// ---- perspective

/// A wall with u = 0 at depth 1 on its left and u = 1 at depth 3 on its right.
mesh::Mesh receding_wall() {
    mesh::PolygonSoup soup;
    soup.positions = {{-1, -1, -1}, {3, -3, -3}, {3, 3, -3}, {-1, 1, -1}};
    soup.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    constexpr auto none = mesh::PolygonSoup::none;
    soup.corners = {{0, none, 0}, {1, none, 1}, {2, none, 2}, {3, none, 3}};
    soup.face_begin = {0, 4};
    return mesh::build(soup).mesh;
}

/// The wall from the left border of a picture to its right one.
Scene wall_scene(const mesh::Mesh& wall, raster::Viewport viewport,
                 const shading::Texture& texture) {
    Scene scene = evenly_lit(wall, {}, texture);
    scene.camera = {};
    scene.camera.eye = glm::dvec3(0.0);
    scene.camera.target = {0.0, 0.0, -1.0};
    scene.camera.magnification = static_cast<double>(viewport.width) / viewport.height;
    scene.camera.near = 0.5;
    scene.camera.far = 5.0;
    return scene;
}

/// u of the wall at a pixel of the middle row.
double u_at(int x, int width, Perspective perspective) {
    const auto wall = receding_wall();
    const raster::Viewport viewport{width, 9};
    Settings settings;
    settings.perspective = perspective;
    const Drawing drawing = draw(wall_scene(wall, viewport, image_of_u()), settings, viewport);
    return drawing.framebuffer.color.at(x, 4).r;
}

// DEFE.b and DEFE.c: the middle of the screen, and a quarter of it.
TEST(TextureLaws, DEFE_b_c_AnImageIsEvenOverTheWallOrOverTheScreen) {
    EXPECT_NEAR(u_at(20, 41, Perspective::correct), 0.25, 1e-3);
    EXPECT_NEAR(u_at(20, 41, Perspective::affine), 0.5, 1e-3);
    EXPECT_NEAR(u_at(10, 42, Perspective::correct), 0.1, 1e-3);
    EXPECT_NEAR(u_at(10, 42, Perspective::affine), 0.25, 1e-3);
}

// C12.4.1-IMAGE
TEST(TextureLaws, AnImageLiesWhereItsPointsAre) {
    const auto wall = receding_wall();
    std::size_t compared = 0;
    for_each_point(wall_scene(wall, size, image_of_u()), {}, size,
                   [&](int x, int y, const glm::dvec3& point, float color) {
                       const double u = std::clamp((-point.z - 1.0) / 2.0, 0.5 / 64, 63.5 / 64);
                       ASSERT_NEAR(color, u, 2e-3) << x << ' ' << y;
                       ++compared;
                   });
    EXPECT_GT(compared, 3000u);
}

// C12.1.3-PERSP: stripes stand elsewhere, and are as the wall's own only in the one mode.
TEST(TextureLaws, StripesDifferBetweenAffineAndCorrect) {
    shading::Texture stripes;
    stripes.pattern = shading::Pattern::stripes;
    const auto wall = receding_wall();
    const auto wrong_pixels = [&](Perspective perspective) {
        Settings settings;
        settings.perspective = perspective;
        int wrong = 0;
        for_each_point(wall_scene(wall, size, stripes), settings, size,
                       [&](int, int, const glm::dvec3& point, float color) {
                           const double in_stripe = (-point.z - 1.0) / 2.0 * 8.0;
                           const double place = in_stripe - std::floor(in_stripe);
                           const double to_edge = std::abs(std::remainder(place, 0.5));
                           if (to_edge < 0.01) return;
                           wrong += (color > 0.5f) != (place < 0.5) ? 1 : 0;
                       });
        return wrong;
    };
    EXPECT_EQ(wrong_pixels(Perspective::correct), 0);
    EXPECT_GT(wrong_pixels(Perspective::affine), 1000);
}

// ---- auxiliary surfaces and space

glm::dvec3 texture_point(const shading::Texture& texture, const glm::dvec3& point) {
    return glm::dvec3(glm::dmat4(texture.texture_from_object) * glm::dvec4(point, 1.0));
}

// C12.4.2-CYL: the seam, where u goes from 1 to 0, in the middle of the picture. No pixel has what
// lies between.
TEST(TextureLaws, TheSeamOfACylinderIsNotSmeared) {
    const auto mesh = shape_mesh("cylinder:32");
    shading::Texture around;
    around.pattern = shading::Pattern::gradient;
    around.mapping = shading::Mapping::cylindrical;
    around = fitted(around, mesh::bounding_box(mesh), Axis::y, 1.0);
    const Scene scene = evenly_lit(mesh, {{0.0, 0.0}, size}, around);
    int near_0 = 0;
    int near_1 = 0;
    for_each_point(scene, {}, size, [&](int x, int y, const glm::dvec3& point, float color) {
        const glm::dvec3 p = texture_point(around, point);
        const double turns = std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
        ASSERT_NEAR(std::remainder(static_cast<double>(color) - turns, 1.0), 0.0, 1e-3)
            << x << ' ' << y;
        near_0 += color < 0.03f ? 1 : 0;
        near_1 += color > 0.97f ? 1 : 0;
    });
    EXPECT_GT(near_0, 50);
    EXPECT_GT(near_1, 50);
}

// C12.4.3-SOLID: on all faces of a block the pattern is one function of the point, so that it goes
// on across the edges.
TEST(TextureLaws, MarbleGoesOnAcrossTheEdgesOfABlock) {
    const auto mesh = shape_mesh("cube");
    shading::Texture marble;
    marble.pattern = shading::Pattern::marble;
    marble = fitted(marble, mesh::bounding_box(mesh), Axis::y, 0.2);
    const Scene scene = evenly_lit(mesh, {{30.0, 25.0}, size}, marble);
    const auto items = draw_items(scene, {}, size);
    raster::Plane<float> colors(size, -1.0f);
    for_each_point(scene, {}, size, [&](int x, int y, const glm::dvec3& point, float color) {
        const double expected = shading::marble(texture_point(marble, point), 1.0);
        ASSERT_NEAR(color, expected, 0.01) << x << ' ' << y;
        colors.at(x, y) = color;
    });
    float within = 0.0f;
    float across = 0.0f;
    int pairs = 0;
    for_each_pixel(size, [&](int x, int y) {
        if (x == 0 || items.at(x, y) == 0 || items.at(x - 1, y) == 0) return;
        const float step = std::abs(colors.at(x, y) - colors.at(x - 1, y));
        const bool is_edge = items.at(x, y) != items.at(x - 1, y);
        pairs += is_edge ? 1 : 0;
        (is_edge ? across : within) = std::max(is_edge ? across : within, step);
    });
    EXPECT_GT(pairs, 30);
    EXPECT_LT(across, 1.5f * within);
    EXPECT_LT(across, 0.3f);
}

// C12.4.4-BUMP
TEST(TextureLaws, BumpsChangeTheShadingAndNotTheSilhouette) {
    const auto mesh = shape_mesh("sphere:32,16");
    shading::Texture waves;
    waves.pattern = shading::Pattern::waves;
    waves.mapping = shading::Mapping::spherical;
    waves = fitted(waves, mesh::bounding_box(mesh), Axis::y, 1.0);
    Scene scene = scene_of(mesh, {{30.0, 20.0}, size});
    const auto smooth = draw(scene, {}, size).framebuffer;
    shading::SurfaceTextures textures;
    textures.bump = waves;
    textures.bump_height = 0.05f;
    scene.objects.front().textures.assign(mesh.materials.size(), textures);
    const auto bumped = draw(scene, {}, size).framebuffer;
    EXPECT_EQ(bumped.depth, smooth.depth);
    EXPECT_GT(different_pixels(bumped, smooth), covered_pixels(smooth.depth) / 2);
    for_each_pixel(
        size, [&](int x, int y) { ASSERT_EQ(bumped.color.at(x, y).a, smooth.color.at(x, y).a); });
}

}  // namespace
}  // namespace scanlight::render
