#include "raster/project.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"
#include "tests/raster/cases.h"
#include "tests/raster/filled.h"
#include "tests/raster/reference_coverage.h"
#include "tests/raster/reference_values.h"

namespace scanlight::raster {
namespace {

using laws::Random;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Snapped, PutsTheCornersOfTheViewOnTheCornersOfThePicture) {
    const Viewport view{640, 480};
    const auto top_left = snapped<0>({-2.0f, 2.0f, 0.0f, 2.0f}, view);
    EXPECT_EQ(top_left.x, 0);
    EXPECT_EQ(top_left.y, 0);
    EXPECT_EQ(top_left.z, 0);
    const auto bottom_right = snapped<0>({2.0f, -2.0f, 2.0f, 2.0f}, view);
    EXPECT_EQ(bottom_right.x, 640 * subpixels);
    EXPECT_EQ(bottom_right.y, 480 * subpixels);
    EXPECT_EQ(bottom_right.z, depth_far);
    const auto middle = snapped<0>({0.0f, 0.0f, 0.5f, 1.0f}, view);
    EXPECT_EQ(middle.x, 320 * subpixels);
    EXPECT_EQ(middle.y, 240 * subpixels);
}

TEST(Snapped, StaysInThePictureWhateverComes) {
    const float numbers[] = {nan, infinity, -infinity, 0.0f, -0.0f, 1e38f, -1e38f, 1e-40f, 1.0f};
    const Viewport view{max_size, 1};
    for (const float x : numbers) {
        for (const float z : numbers) {
            for (const float w : numbers) {
                const auto v = snapped<0>({x, z, z, w}, view);
                EXPECT_TRUE(v.x >= 0 && v.x <= max_size * subpixels);
                EXPECT_TRUE(v.y >= 0 && v.y <= subpixels);
                EXPECT_TRUE(v.z >= 0 && v.z <= depth_far);
            }
        }
    }
}

TEST(Snapped, RoundsToTheNearestSubpixel) {
    Random random(1);
    for (int i = 0; i < laws::million; ++i) {
        const int size = random.between(1, 4096);
        const float x = random.real(-1.0f, 1.0f);
        const double exact = (static_cast<double>(x) + 1.0) * 0.5 * size * subpixels;
        ASSERT_NEAR(snapped<0>({x, 0.0f, 0.0f, 1.0f}, {size, size}).x, exact, 0.57);
    }
}

std::vector<ScreenVertex<0>> rectangle(int width, int height) {
    return laws::without_values<0>({{0, 0}, {0, height}, {width, height}, {width, 0}});
}

TEST(SignedArea, IsPositiveForCounterClockwiseOnTheScreen) {
    auto ccw = rectangle(512, 256);
    EXPECT_EQ(signed_area(ccw), 2 * 512 * 256);
    std::reverse(ccw.begin(), ccw.end());
    EXPECT_EQ(signed_area(ccw), -2 * 512 * 256);
    EXPECT_EQ(signed_area(std::vector<ScreenVertex<0>>{}), 0);
}

TEST(SignedArea, OfTheLargestPictureIsExact) {
    constexpr std::int64_t end = max_size * subpixels;
    EXPECT_EQ(signed_area(rectangle(end, end)), 2 * end * end);
}

/// A parameter that runs from 0 at depth w = 1 on the left to 1 at depth w = 3 on the right, from
/// the centre of column 32 to the centre of column 96. Next to it a 1, which becomes q.
std::vector<ClipVertex<2>> receding_wall() {
    const auto corner = [](float pixel, float y, float w, float parameter) {
        const float x = pixel / 64.0f - 1.0f;
        return ClipVertex<2>{{x * w, y * w, 0.5f * w, w}, {parameter, 1.0f}};
    };
    return {corner(32.5f, 0.9f, 1.0f, 0.0f), corner(32.5f, -0.9f, 1.0f, 0.0f),
            corner(96.5f, -0.9f, 3.0f, 1.0f), corner(96.5f, 0.9f, 3.0f, 1.0f)};
}

/// The two values at a column of the picture's middle row.
std::array<double, 2> values_at(const std::vector<ScreenVertex<2>>& polygon, int column) {
    std::array<double, 2> values{};
    for (const auto& span : laws::spans_of(polygon, Interpolation::bilinear)) {
        if (span.y != 64) continue;
        for (std::size_t k = 0; k < 2; ++k) {
            const Ramp ramp = laws::ahead(span.ramps.attributes[k], column - span.x_begin);
            values[k] = float_from_attribute(ramp.get());
        }
    }
    return values;
}

double affine_at(int column) {
    return values_at(project_affine(receding_wall(), {128, 128}), column)[0];
}

double correct_at(int column) {
    const auto [value, q] = values_at(project_correct(receding_wall(), {128, 128}), column);
    return value / q;
}

TEST(Oracle, DEFE_b_MiddleOfTheScreenIsNotTheMiddleOfTheWall) {
    EXPECT_NEAR(correct_at(64), 0.25, 1e-7);
    EXPECT_NEAR(affine_at(64), 0.5, 1e-7);
}

TEST(Oracle, DEFE_c_QuarterOfTheScreenIsATenthOfTheWall) {
    EXPECT_NEAR(correct_at(48), 0.1, 1e-7);
    EXPECT_NEAR(affine_at(48), 0.25, 1e-7);
}

/// A triangle in front of the eye; the second attribute is 1.
std::vector<ClipVertex<2>> random_triangle(Random& random, float farthest) {
    std::vector<ClipVertex<2>> t(3);
    for (auto& v : t) {
        const float w = random.one_in(2) ? random.real(1.0f, 2.0f) : random.real(1.0f, farthest);
        v.position = {w * random.real(-1.0f, 1.0f), w * random.real(-1.0f, 1.0f),
                      w * random.real(0.0f, 1.0f), w};
        v.attributes = {random.real(-1.0f, 1.0f), 1.0f};
    }
    return t;
}

TEST(ProjectCorrect, KeepsQAboveZeroAndUpToOne) {
    Random random(2);
    for (int i = 0; i < laws::million; ++i) {
        int ones = 0;
        for (const auto& v : project_correct(random_triangle(random, 1e5f), {100, 100})) {
            ASSERT_GT(v.attributes[1], 0);
            ASSERT_LE(v.attributes[1], 1 << 29);
            ones += v.attributes[1] == 1 << 29 ? 1 : 0;
        }
        ASSERT_GE(ones, 1);  // the nearest corner
    }
}

/// What a perspective-correct attribute is at a pixel's centre, and q there.
struct Exact {
    double value, q;
};

Exact exact_at(const std::vector<ClipVertex<2>>& t, const laws::Points& p, int column, int row) {
    const ScreenPoint c = laws::centre_of(column, row);
    long double sum = 0.0L;
    long double weights = 0.0L;
    float w_min = t[0].position.w;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto share =
            static_cast<long double>(laws::cross(c, p[(i + 1) % 3], p[(i + 2) % 3])) /
            t[i].position.w;
        sum += share * t[i].attributes[0];
        weights += share;
        w_min = std::min(w_min, t[i].position.w);
    }
    const auto area = static_cast<long double>(laws::cross(p[0], p[1], p[2]));
    return {static_cast<double>(sum / weights), static_cast<double>(weights / area * w_min)};
}

/// a q and q are each off by `units` at most, and so a by twice that over q.
void expect_correct(Interpolation rule, float farthest, int size, int count) {
    Random random(3);
    PolygonFiller<2> filler;
    for (int i = 0; i < count; ++i) {
        const auto t = random_triangle(random, farthest);
        const auto projected = project_correct(t, {size, size});
        const auto points = laws::points_of(projected);
        for (const auto& span : laws::spans_of(filler, projected, rule)) {
            const auto [value, q] = exact_at(t, points, span.x_begin, span.y);
            const double units = rule == Interpolation::bilinear ? 2.0 : 2.0 + size;
            const double seen = static_cast<double>(span.ramps.attributes[0].get()) /
                                span.ramps.attributes[1].get();
            // Floats round a q, q and w itself.
            ASSERT_NEAR(seen, value, 2.0 * units / (q * attribute_one) + 3e-7)
                << testing::PrintToString(points) << span.x_begin << ", " << span.y;
        }
    }
}

TEST(ProjectCorrect, GivesTheExactValueAtEachPixel) {
    expect_correct(Interpolation::bilinear, 1000.0f, 64, laws::cases(30'000));
    expect_correct(Interpolation::planar, 1000.0f, 64, laws::cases(30'000));
}

TEST(ProjectCorrect, OfOneColourIsThatColour) {
    Random random(4);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::cases(50'000); ++i) {
        auto t = random_triangle(random, 20.0f);
        for (auto& v : t)
            v.attributes[0] = 0.75f;
        for (const auto& span :
             laws::spans_of(filler, project_correct(t, {32, 32}), Interpolation::bilinear)) {
            const double value = static_cast<double>(span.ramps.attributes[0].get()) /
                                 span.ramps.attributes[1].get();
            ASSERT_NEAR(value, 0.75, 2e-7);
        }
    }
}

}  // namespace
}  // namespace scanlight::raster
