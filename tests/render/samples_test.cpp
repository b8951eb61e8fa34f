#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/draw.h"
#include "render/renderer.h"
#include "tests/raster/cases.h"
#include "tests/same_bits/pixel_view.h"
#include "tests/same_bits/plain_mesh.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport one_pixel{1, 1};

struct Point {
    double x, y;
};
using Polygon = std::vector<Point>;

/// What of a polygon lies on the left of the line through (x, y) with this normal.
Polygon cut(const Polygon& polygon, Point through, Point normal) {
    const auto side = [&](const Point& p) {
        return (p.x - through.x) * normal.x + (p.y - through.y) * normal.y;
    };
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i];
        const Point b = polygon[(i + 1) % polygon.size()];
        const double da = side(a);
        const double db = side(b);
        if (da <= 0.0) result.push_back(a);
        if ((da < 0.0) != (db < 0.0) && da != db) {
            const double t = da / (da - db);
            result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return result;
}

double area(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2.0;
}

/// White on black, from a square about the pixel, cut by a line.
same_bits::TestScene edge_through_pixel(Point through, Point normal) {
    same_bits::TestScene test{one_pixel, {.shading = Shading::flat}, {}, {}};
    same_bits::PlainPolygon polygon{{}, {0.0f, 0.0f, 1.0f}, 0};
    for (const Point& p :
         cut({{-5.0, -5.0}, {-5.0, 5.0}, {5.0, 5.0}, {5.0, -5.0}}, through, normal))
        polygon.corners.push_back({same_bits::at_pixel(p.x, p.y, 0.0), polygon.normal});
    Object object{&test.keep(same_bits::plain_mesh({polygon})), {{}}};
    object.materials.front().ambient = glm::vec3(1.0f);
    test.scene.objects = {object};
    test.scene.camera = same_bits::pixel_camera(one_pixel);
    test.scene.lighting.ambient = glm::vec3(1.0f);
    return test;
}

TEST(Samples, ApproachTheExactCoverageOfAStraightEdge) {
    raster::laws::Random random(5);
    double squares[5] = {};
    const int count = raster::laws::cases(2000);
    for (int i = 0; i < count; ++i) {
        const Point through{random.real(0.0f, 1.0f), random.real(0.0f, 1.0f)};
        const Point normal{random.real(-1.0f, 1.0f), random.real(-1.0f, 1.0f)};
        same_bits::TestScene test = edge_through_pixel(through, normal);
        const double exact = area(cut({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, through, normal));
        for (const int grid : {1, 2, 4}) {
            test.settings.grid = grid;
            const Drawing drawing = draw(test.scene, test.settings, test.size);
            const double error = drawing.framebuffer.color.at(0, 0).a - exact;
            EXPECT_LE(std::abs(error), 1.0 / grid + 1.0 / 256.0);
            squares[grid] += error * error;
        }
    }
    EXPECT_GT(squares[1], 0.0);
    EXPECT_LT(squares[2], 0.4 * squares[1]);
    EXPECT_LT(squares[4], 0.4 * squares[2]);
}

TEST(Samples, AreNotSeenWhereNothingChanges) {
    for (const int grid : {1, 2, 4}) {
        same_bits::TestScene test = edge_through_pixel({4.0, 4.0}, {1.0, 0.1});
        test.settings.grid = grid;
        const Drawing drawing = draw(test.scene, test.settings, test.size);
        EXPECT_EQ(drawing.framebuffer.color.at(0, 0), raster::Rgba(1.0f));
    }
}

TEST(Samples, BeforeNothingHaveTheirColourAndAShareOfAlpha) {
    same_bits::TestScene test = edge_through_pixel({0.5, 0.5}, {1.0, 0.0});
    test.settings.grid = 4;
    const Drawing drawing = draw(test.scene, test.settings, test.size);
    const raster::Rgba half(1.0f, 1.0f, 1.0f, 0.5f);
    EXPECT_EQ(drawing.framebuffer.color.at(0, 0), half);
    EXPECT_EQ(raster::packed_pixel(half, raster::Encoding::srgb), 0x80ffffffu);
}

TEST(Samples, LeaveDepthToThePixelsCentres) {
    same_bits::TestScene test = edge_through_pixel({0.6, 0.5}, {1.0, 0.3});
    const Drawing one = draw(test.scene, test.settings, test.size);
    test.settings.grid = 4;
    const Drawing many = draw(test.scene, test.settings, test.size);
    EXPECT_TRUE(one.framebuffer.depth == many.framebuffer.depth);
    Renderer renderer;
    raster::Plane<raster::Rgba> color(test.size, raster::Rgba(0.0f));
    raster::Plane<raster::Depth> depth(test.size, 0);
    renderer.draw(test.scene, test.settings, color, &depth);
    EXPECT_TRUE(depth == one.framebuffer.depth);
}

}  // namespace
}  // namespace scanlight::render
