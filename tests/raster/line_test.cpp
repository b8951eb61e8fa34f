#include "raster/line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "tests/raster/cases.h"

namespace scanlight::raster {

inline bool operator==(const LinePixel& a, const LinePixel& b) {
    return a.x == b.x && a.y == b.y && a.depth == b.depth;
}

namespace {

using laws::Random;

std::vector<LinePixel> pixels_of(const ScreenVertex<0>& a, const ScreenVertex<0>& b,
                                 Viewport viewport) {
    std::vector<LinePixel> pixels;
    draw_line(a, b, viewport, [&pixels](const LinePixel& pixel) { pixels.push_back(pixel); });
    return pixels;
}

ScreenVertex<0> at(double x, double y, Depth z = 0) {
    return {static_cast<SubPixel>(std::lrint(x * subpixels)),
            static_cast<SubPixel>(std::lrint(y * subpixels)),
            z,
            {}};
}

TEST(DrawLine, DrawsFlatSteepAndDiagonalLines) {
    const Viewport view{10, 10};
    EXPECT_EQ(pixels_of(at(1.5, 2.5), at(4.5, 2.5), view),
              (std::vector<LinePixel>{{1, 2, 0}, {2, 2, 0}, {3, 2, 0}, {4, 2, 0}}));
    EXPECT_EQ(pixels_of(at(2.5, 1.5), at(2.5, 3.5), view),
              (std::vector<LinePixel>{{2, 1, 0}, {2, 2, 0}, {2, 3, 0}}));
    EXPECT_EQ(pixels_of(at(0.5, 0.5), at(2.5, 2.5), view),
              (std::vector<LinePixel>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}));
    EXPECT_EQ(pixels_of(at(0.5, 0.5), at(4.5, 2.5), view),
              (std::vector<LinePixel>{{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 2, 0}, {4, 2, 0}}));
}

TEST(DrawLine, StepsDepthFromEndToEnd) {
    EXPECT_EQ(pixels_of(at(0.5, 0.5, 100), at(2.5, 0.5, 300), {10, 10}),
              (std::vector<LinePixel>{{0, 0, 100}, {1, 0, 200}, {2, 0, 300}}));
}

TEST(DrawLine, OfOnePointIsOnePixelTheSameBothWays) {
    const auto forth = pixels_of(at(3.2, 4.7, 50), at(3.2, 4.7, 9), {10, 10});
    ASSERT_EQ(forth.size(), 1u);
    EXPECT_EQ(forth[0].x, 3);
    EXPECT_EQ(forth[0].y, 4);
    EXPECT_EQ(pixels_of(at(3.2, 4.7, 9), at(3.2, 4.7, 50), {10, 10}), forth);
}

TEST(DrawLine, BetweenTwoPixelsKeepsDepthBetweenItsEnds) {
    const auto pixels = pixels_of({255, 100, 0, {}}, {256, 100, depth_far, {}}, {10, 10});
    EXPECT_EQ(pixels, (std::vector<LinePixel>{{0, 0, 0}, {1, 0, depth_far}}));
}

TEST(DrawLine, LeavesOutWhatIsOutsideOfThePicture) {
    const auto pixels = pixels_of(at(0, 3), at(8, 3), {4, 3});
    EXPECT_TRUE(pixels.empty());
    EXPECT_EQ(pixels_of(at(0, 2), at(8, 2), {4, 3}).size(), 4u);
}

ScreenVertex<0> random_end(Random& random, int extent) {
    const SubPixel x = random.between(0, extent);
    return {x, random.between(0, extent), random.between(0, depth_far), {}};
}

struct RandomLine {
    ScreenVertex<0> a, b;
    Viewport view;
};

RandomLine random_line(Random& random) {
    const int size = random.one_in(500) ? max_size : random.between(1, 20);
    const auto a = random_end(random, size * subpixels);
    return {a, random_end(random, size * subpixels), {size, size}};
}

TEST(DrawLine, IsTheSameInBothDirections) {
    Random random(1);
    for (int i = 0; i < laws::cases(500'000); ++i) {
        const auto [a, b, view] = random_line(random);
        ASSERT_EQ(pixels_of(a, b, view), pixels_of(b, a, view));
    }
}

/// How far a pixel's centre is from the line through a and b across its run, in pixels.
double off_line(const LinePixel& p, const ScreenVertex<0>& a, const ScreenVertex<0>& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double x = (p.x + 0.5) * subpixels - a.x;
    const double y = (p.y + 0.5) * subpixels - a.y;
    return std::abs(dx * y - dy * x) / std::max(std::abs(dx), std::abs(dy)) / subpixels;
}

testing::AssertionResult is_good(const LinePixel& p, const RandomLine& line) {
    const auto& [a, b, view] = line;
    const auto low = std::minmax(a.x, b.x);
    const auto across = std::minmax(a.y, b.y);
    const bool in_view = p.x >= 0 && p.x < view.width && p.y >= 0 && p.y < view.height;
    const bool in_box = p.x >= low.first >> subpixel_bits && p.x <= low.second >> subpixel_bits &&
                        p.y >= across.first >> subpixel_bits &&
                        p.y <= across.second >> subpixel_bits;
    const bool in_depth = p.depth >= std::min(a.z, b.z) && p.depth <= std::max(a.z, b.z);
    const bool moves = a.x != b.x || a.y != b.y;
    // Half a pixel, and half more where the end of the line is held.
    const bool near = !moves || off_line(p, a, b) <= 1.01;
    if (in_view && in_box && in_depth && near) return testing::AssertionSuccess();
    return testing::AssertionFailure() << p.x << ", " << p.y << " at " << p.depth << " from " << a.x
                                       << ", " << a.y << " to " << b.x << ", " << b.y;
}

TEST(DrawLine, StaysOnTheLineInItsBoxItsDepthsAndThePicture) {
    Random random(2);
    for (int i = 0; i < laws::cases(200'000); ++i) {
        const RandomLine line = random_line(random);
        for (const auto& pixel : pixels_of(line.a, line.b, line.view))
            ASSERT_TRUE(is_good(pixel, line));
    }
}

TEST(DrawLine, HasOnePixelForEachStepOfTheLongerWay) {
    Random random(3);
    for (int i = 0; i < laws::cases(200'000); ++i) {
        const auto a = random_end(random, 20 * subpixels - 1);
        const auto b = random_end(random, 20 * subpixels - 1);
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        const int from = (steep ? std::min(a.y, b.y) : std::min(a.x, b.x)) >> subpixel_bits;
        const int to = (steep ? std::max(a.y, b.y) : std::max(a.x, b.x)) >> subpixel_bits;
        const auto pixels = pixels_of(a, b, {20, 20});
        ASSERT_EQ(pixels.size(), static_cast<std::size_t>(to - from + 1));
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            ASSERT_EQ(steep ? pixels[k].y : pixels[k].x, from + static_cast<int>(k));
            if (k > 0) {
                ASSERT_LE(std::abs(pixels[k].x - pixels[k - 1].x), 1);
                ASSERT_LE(std::abs(pixels[k].y - pixels[k - 1].y), 1);
            }
        }
    }
}

ClipVertex<0> random_clip_vertex(Random& random) {
    const float w = random.real(-1.0f, 3.0f);
    return {{random.real(-4.0f, 4.0f), random.real(-4.0f, 4.0f), random.real(-2.0f, 4.0f), w}, {}};
}

TEST(ClipLine, LeavesWhatIsInsideAsItIs) {
    const ClipVertex<0> a{{-1.0f, -1.0f, 0.0f, 1.0f}, {}};
    const ClipVertex<0> b{{1.0f, 1.0f, 1.0f, 1.0f}, {}};
    const auto clipped = clip_line(a, b);
    ASSERT_TRUE(clipped);
    EXPECT_EQ(clipped->first.position, a.position);
    EXPECT_EQ(clipped->second.position, b.position);
}

TEST(ClipLine, LeavesNothingOfWhatIsOutside) {
    EXPECT_FALSE(clip_line({{-3.0f, 0.0f, 0.5f, 1.0f}, {}}, {{-2.0f, 0.0f, 0.5f, 1.0f}, {}}));
    EXPECT_FALSE(clip_line({{0.0f, 0.0f, -1.0f, -2.0f}, {}}, {{0.0f, 1.0f, -1.0f, -1.0f}, {}}));
    EXPECT_FALSE(clip_line({{-3.0f, 0.0f, 0.5f, 1.0f}, {}}, {{0.0f, 3.0f, 0.5f, 1.0f}, {}}));
}

TEST(ClipLine, IsTheSameInBothDirectionsAndInside) {
    Random random(4);
    int left = 0;
    for (int i = 0; i < laws::million; ++i) {
        const auto a = random_clip_vertex(random);
        const auto b = random_clip_vertex(random);
        const auto forth = clip_line(a, b);
        const auto back = clip_line(b, a);
        ASSERT_EQ(forth.has_value(), back.has_value());
        if (!forth) continue;
        ++left;
        ASSERT_EQ(forth->first.position, back->second.position);
        ASSERT_EQ(forth->second.position, back->first.position);
        for (const ClipPlane plane : clip_planes) {
            ASSERT_GE(distance(forth->first.position, plane), -2e-6f);
            ASSERT_GE(distance(forth->second.position, plane), -2e-6f);
        }
    }
    EXPECT_GT(left, laws::million / 10);
}

}  // namespace
}  // namespace scanlight::raster
