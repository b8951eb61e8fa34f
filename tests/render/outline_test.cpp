// DEFE.a: whatever the shading, the outline of a round body stays a polygon. The error of a circle
// of radius R as an n-gon is R (1 - cos(pi / n)), here measured in the picture.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr double radius = 200.0;  // pixels
constexpr raster::Viewport size{440, 440};

raster::Framebuffer drawn_polygon(int corners) {
    const auto mesh = shape_mesh("ngon:" + std::to_string(corners));
    Scene scene = scene_of(mesh, {{0.0, 0.0}, size, Projection::orthographic});
    scene.camera.eye = {0.0, 0.0, 5.0};
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.magnification = radius / (0.5 * size.height);
    scene.camera = with_fitted_planes(scene.camera, scene.objects);
    return draw(scene, {}, size).framebuffer;
}

/// How deep into the circle the deepest pixel centre lies that the polygon leaves out.
double measured_error(int corners) {
    const auto framebuffer = drawn_polygon(corners);
    double deepest = 0.0;
    for_each_pixel(size, [&](int x, int y) {
        if (framebuffer.depth.at(x, y) != raster::depth_clear) return;
        const double r = std::hypot(x + 0.5 - 0.5 * size.width, y + 0.5 - 0.5 * size.height);
        deepest = std::max(deepest, radius - r);
    });
    return deepest;
}

TEST(Outline, DefeA_ErrorOfAnEightSixteenAndSixtyFourGon) {
    constexpr double snapping = 1.0 / 128.0;
    const std::pair<int, double> cases[] = {{8, 15.2240935}, {16, 3.84294392}, {64, 0.240908759}};
    for (const auto& [corners, expected] : cases) {
        const double error = measured_error(corners);
        EXPECT_LT(error, expected + snapping) << corners;
        EXPECT_GT(error, expected - 0.15) << corners;  // pixel centres lie apart
    }
}

TEST(Outline, NoPolygonReachesBeyondItsCircle) {
    for (const int corners : {3, 8, 64}) {
        const auto framebuffer = drawn_polygon(corners);
        for_each_pixel(size, [&](int x, int y) {
            if (framebuffer.depth.at(x, y) == raster::depth_clear) return;
            const double r = std::hypot(x + 0.5 - 0.5 * size.width, y + 0.5 - 0.5 * size.height);
            ASSERT_LT(r, radius + 1.0 / 128.0);
        });
    }
}

}  // namespace
}  // namespace scanlight::render
