#include "raster/plane.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"
#include "tests/raster/filled.h"
#include "tests/raster/random_polygons.h"
#include "tests/raster/reference_values.h"

namespace scanlight::raster {
namespace {

using laws::Points;
using laws::Random;
using laws::spans_of;

using Triangle = std::vector<ScreenVertex<1>>;

constexpr int screen = max_size * subpixels;

/// Triangles of all sizes and shapes, up to the largest picture.
Triangle random_triangle(Random& random) {
    const int extent =
        random.one_in(200) ? screen : random.between(2, random.one_in(8) ? 90 : 9) * subpixels;
    const Points points = random.one_in(3) ? laws::random_sliver(random, extent)
                                           : laws::random_triangle(random, extent);
    return laws::with_random_values<1>(points, random);
}

/// The bound that `attribute_plane` states.
double attribute_bound(const Triangle& t, int x, int y) {
    const int distance =
        std::abs(x - (t[0].x >> subpixel_bits)) + std::abs(y - (t[0].y >> subpixel_bits));
    return 17.0 / 32.0 * distance + 1.0;
}

/// Attributes are whole units on a plane, and known modulo 2^32; so are they looked at here.
std::int64_t attribute_at(const Span<1>& span, int x) {
    return laws::ahead(span.ramps.attributes[0], x - span.x_begin).get();
}

/// Calls `check(x, span)` at both ends of each span: in between everything is linear.
template <class Check>
void at_span_ends(PolygonFiller<1>& filler, const Triangle& triangle, Check&& check) {
    for (const auto& span : spans_of(filler, triangle, Interpolation::planar)) {
        check(span.x_begin, span);
        check(span.x_end - 1, span);
    }
}

testing::AssertionResult keeps_the_bounds(PolygonFiller<1>& filler, const Triangle& t) {
    auto result = testing::AssertionSuccess();
    const Points points = laws::points_of(t);
    const auto attributes = laws::corner_attributes(t, 0);
    const auto depths = laws::corner_depths(t);
    at_span_ends(filler, t, [&](int x, const Span<1>& span) {
        const std::int64_t attribute = attribute_at(span, x) << ramp_bits;
        const Ramp depth = laws::ahead(span.ramps.depth, x - span.x_begin);
        const double wrong = laws::error_from_plane(attribute, points, attributes, x, span.y);
        const double wrong_depth = laws::error_from_plane(depth.value, points, depths, x, span.y);
        const bool kept = std::abs(wrong) <= attribute_bound(t, x, span.y) &&
                          std::abs(wrong_depth) < 0.5 && laws::beyond(depth.get(), depths) == 0;
        if (kept) return;
        result = testing::AssertionFailure()
                 << "attribute off by " << wrong << ", depth by " << wrong_depth << " at " << x
                 << ", " << span.y << " of " << testing::PrintToString(points);
    });
    return result;
}

TEST(Planar, ReadsTheCornersValuesAtTheCorners) {
    // Right-angled, corners on the centres of pixels (0, 0), (8, 0), (0, 4).
    const Triangle t{{128, 128, 0, {800}}, {2176, 128, 1600, {1600}}, {128, 1152, 800, {0}}};
    const auto spans = spans_of(t, Interpolation::planar);
    ASSERT_EQ(spans.size(), 4u);
    EXPECT_EQ(spans[0].ramps.attributes[0].get(), 800);
    EXPECT_EQ(spans[0].ramps.attributes[0].step_size, 100 << ramp_bits);
    EXPECT_EQ(spans[1].ramps.attributes[0].get(), 600);
    EXPECT_EQ(spans[0].ramps.depth.get(), 0);
    EXPECT_EQ(spans[0].ramps.depth.step_size, 200 << ramp_bits);
    EXPECT_EQ(spans[2].ramps.depth.get(), 400);
}

TEST(Planar, KeepsItsBoundsFromTheExactPlane) {
    Random random(1);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::million; ++i)
        ASSERT_TRUE(keeps_the_bounds(filler, random_triangle(random)));
}

/// Values as a smooth mesh has them: the gradient is small however thin the triangle.
Triangle with_smooth_values(const Points& points, Random& random) {
    Triangle t = laws::without_values<1>(points);
    const int right = random.between(0, 99);
    const int down = random.between(0, 99);
    for (auto& corner : t) {
        corner.z = right * corner.x + down * corner.y;
        corner.attributes[0] = corner.z;
    }
    return t;
}

/// Long, and down to 1/32 of a sub-pixel wide and beyond.
Points random_thread(Random& random) {
    const int extent = screen >> random.between(0, 6);
    return laws::random_sliver(random, extent);
}

TEST(Planar, KeepsItsBoundsOnTheThinnestTriangles) {
    Random random(2);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(3000); ++i)
        ASSERT_TRUE(keeps_the_bounds(filler, with_smooth_values(random_thread(random), random)));
}

/// The largest change a pixel of the attribute, in units.
double steepness(const Triangle& t) {
    const auto setup = plane_setup({t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y});
    if (!setup) return 0.0;
    const Gradient g = gradient(*setup, t[0].attributes[0], t[1].attributes[0], t[2].attributes[0]);
    return std::max(std::abs(g.dx), std::abs(g.dy));
}

TEST(Planar, KeepsItsBoundsWhereGradientsWrapRound) {
    Random random(8);
    PolygonFiller<1> filler;
    int wrapped = 0;
    for (int i = 0; i < laws::cases(3000); ++i) {
        Triangle t = laws::with_random_values<1>(random_thread(random), random);
        for (auto& corner : t)
            corner.z = 12345;
        wrapped += Planar<1>::of(t) && steepness(t) > 0x1p33 ? 1 : 0;
        ASSERT_TRUE(keeps_the_bounds(filler, t));
    }
    EXPECT_GT(wrapped, laws::cases(3000) / 4);
}

TEST(Planar, NoAttributeHasAGradientOf2To46) {
    Random random(9);
    for (int i = 0; i < laws::cases(200'000); ++i) {
        Triangle t = laws::without_values<1>(random_thread(random));
        for (auto& corner : t) {
            corner.attributes[0] = random.one_in(2) ? std::numeric_limits<Attribute>::max()
                                                    : std::numeric_limits<Attribute>::min();
        }
        ASSERT_LT(steepness(t), 0x1p46);
    }
}

TEST(Planar, EqualsBilinearWithinTheStatedBound) {
    constexpr double one_of_255 = attribute_one / 255.0;
    Random random(3);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::million; ++i) {
        const Triangle t = random_triangle(random);
        const auto planar = spans_of(filler, t, Interpolation::planar);
        const auto bilinear = spans_of(filler, t, Interpolation::bilinear);
        ASSERT_EQ(planar.size(), bilinear.size());
        for (std::size_t k = 0; k < planar.size(); ++k) {
            ASSERT_EQ(planar[k].x_begin, bilinear[k].x_begin);
            ASSERT_EQ(planar[k].x_end, bilinear[k].x_end);
            const double attribute = planar[k].ramps.attributes[0].get() -
                                     laws::units(bilinear[k].ramps.attributes[0].value);
            ASSERT_LE(std::abs(attribute), 0.009 * one_of_255);
            ASSERT_LE(std::abs(planar[k].ramps.depth.get() - bilinear[k].ramps.depth.get()), 1);
        }
    }
}

TEST(Planar, IsAddedUpOrEvaluatedDirectlyTheSameBits) {
    Random random(4);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const Triangle t = laws::with_random_values<1>(
            laws::random_triangle(random, random.between(2, 60) * subpixels), random);
        const auto planar = Planar<1>::of(t);
        if (!planar) continue;
        for (const auto& span : spans_of(filler, t, Interpolation::planar)) {
            Ramps<1> stepped = span.ramps;
            for (int x = span.x_begin; x < span.x_end; ++x, stepped.step()) {
                // A left edge that begins at pixel x, straight down.
                Edge<Planar<1>::EdgeValues> edge;
                edge.crossing = Crossing({x * subpixels, 0}, {x * subpixels, screen}, 0);
                const Ramps<1> direct = planar->along(edge, edge, span.y);
                ASSERT_EQ(direct.depth, stepped.depth);
                ASSERT_EQ(direct.attributes[0].get(), stepped.attributes[0].get());
            }
        }
    }
}

/// One that spans the largest picture, the first corner far from the rest or in their midst.
Points triangle_over_all(Random& random) {
    const auto near_end = [&] {
        const int inset = random.between(0, 2 * subpixels);
        return random.one_in(2) ? inset : screen - inset;
    };
    Points points;
    for (int i = 0; i < 3; ++i) {
        const int x = near_end();
        points.push_back({x, near_end()});
    }
    return points;
}

TEST(Planar, AttributesAtTheEndsOfTheirRangeKeepTheirSign) {
    Random random(11);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(1000); ++i) {
        const Points points = random.one_in(2) ? triangle_over_all(random) : random_thread(random);
        const Attribute end = attribute_from_float(random.one_in(2) ? 1e9f : -1e9f);
        Triangle t = laws::without_values<1>(points);
        for (auto& corner : t)
            corner.attributes[0] = end - (end > 0 ? 1 : -1) * random.between(0, 1 << 14);
        at_span_ends(filler, t, [&](int x, const Span<1>& span) {
            ASSERT_EQ(attribute_at(span, x) > 0, end > 0) << testing::PrintToString(points);
        });
    }
}

TEST(Planar, RefusesTrianglesOfNoArea) {
    Random random(5);
    for (int i = 0; i < laws::cases(100'000); ++i) {
        const int dx = random.between(-500, 500);
        const int dy = random.between(-500, 500);
        const int n = random.between(-9, 9);
        const Triangle t = laws::with_random_values<1>(
            {{9000, 9000}, {9000 + dx, 9000 + dy}, {9000 + n * dx, 9000 + n * dy}}, random);
        ASSERT_FALSE(Planar<1>::of(t));
    }
}

TEST(Planar, RefusesTrianglesThinnerThanTheirThirtySecond) {
    const Triangle refused{{0, 0, 0, {0}}, {32, 1, 0, {0}}, {31, 1, 0, {0}}};
    const Triangle taken{{0, 0, 0, {0}}, {31, 1, 0, {0}}, {30, 1, 0, {0}}};
    EXPECT_FALSE(Planar<1>::of(refused));
    EXPECT_TRUE(Planar<1>::of(taken));
}

TEST(Planar, RefusesSliversWhoseDepthDoesNotFit) {
    // 32 pixels long, 1/256 pixel wide: 2^29 from one side to the other is 2^37 a pixel.
    Triangle t{{128, 0, 0, {0}}, {128, 8192, 0, {0}}, {129, 4096, 1 << 29, {0}}};
    EXPECT_FALSE(Planar<1>::of(t));
    t[2].z = 1 << 20;
    EXPECT_TRUE(Planar<1>::of(t));
}

TEST(Planar, IsChosenWithoutALookAtTheAttributes) {
    Random random(10);
    for (int i = 0; i < laws::million; ++i) {
        Triangle t = random_triangle(random);
        const bool is_planar = Planar<1>::of(t).has_value();
        for (auto& corner : t)
            corner.attributes[0] = 0;
        ASSERT_EQ(Planar<1>::of(t).has_value(), is_planar);
    }
}

TEST(Planar, LeavesWhatItRefusesToBilinear) {
    Random random(6);
    PolygonFiller<1> filler;
    int refused = 0;
    int pixels = 0;
    for (int i = 0; i < laws::million; ++i) {
        const Triangle t =
            laws::with_random_values<1>(laws::random_sliver(random, 30 * subpixels), random);
        if (Planar<1>::of(t)) continue;
        ++refused;
        const auto spans = spans_of(filler, t, Interpolation::planar);
        ASSERT_EQ(spans, spans_of(filler, t, Interpolation::bilinear));
        pixels += static_cast<int>(spans.size());
    }
    EXPECT_GT(refused, laws::million / 100);
    EXPECT_GT(pixels, laws::million / 1000);
}

TEST(Planar, OfOneColourIsThatColourToTheBit) {
    Random random(7);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(200'000); ++i) {
        Triangle t = random_triangle(random);
        for (auto& corner : t) {
            corner.attributes[0] = t[0].attributes[0];
            corner.z = depth_far;
        }
        at_span_ends(filler, t, [&](int x, const Span<1>& span) {
            const int n = x - span.x_begin;
            ASSERT_EQ(laws::ahead(span.ramps.attributes[0], n).get(), t[0].attributes[0]);
            ASSERT_EQ(laws::ahead(span.ramps.depth, n).get(), depth_far);
        });
    }
}

}  // namespace
}  // namespace scanlight::raster
