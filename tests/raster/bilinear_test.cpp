#include "raster/bilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"
#include "raster/trace.h"
#include "tests/raster/filled.h"
#include "tests/raster/random_polygons.h"
#include "tests/raster/reference_values.h"

namespace scanlight::raster {
namespace {

using laws::Points;
using laws::Random;
using laws::spans_of;

// The oracles' coordinates are those of pixel centres here: integer y is a scanline, integer x a
// column. What they print is met to the last digit of the number formats.
constexpr double tolerance = 1e-8;

template <int N>
using Values = std::array<double, N>;

template <int N>
ScreenVertex<N> corner(double x, double y, const Values<N>& values) {
    ScreenVertex<N> v;
    v.x = static_cast<SubPixel>(std::lrint(x * subpixels)) + half_pixel;
    v.y = static_cast<SubPixel>(std::lrint(y * subpixels)) + half_pixel;
    for (std::size_t k = 0; k < N; ++k) {
        v.attributes[k] =
            static_cast<Attribute>(std::lrint(values[k] * static_cast<double>(attribute_one)));
    }
    return v;
}

template <int N>
Trace traced(const std::vector<ScreenVertex<N>>& polygon) {
    Trace trace;
    PolygonFiller<N> filler;
    filler.fill(
        polygon, Interpolation::bilinear, [](const Span<N>&) {}, Tracer<N>(trace));
    return trace;
}

const Trace::Scanline& scanline(const Trace& trace, int y) {
    return trace.scanlines[static_cast<std::size_t>(y - trace.scanlines.front().y)];
}

/// The value of attribute `k` at a pixel of a traced scanline.
double value_at(const Trace& trace, int x, int y, std::size_t k) {
    const auto& span = scanline(trace, y).spans.front();
    return span.values[k] + (x - span.x_begin) * span.steps[k];
}

/// The triangle P1 = (40, 90), P2 = (10, 20), P4 = (80, 30) of the chapter's figure.
template <int N>
Trace chapters_triangle(const Values<N>& v1, const Values<N>& v2, const Values<N>& v4) {
    return traced<N>({corner<N>(40, 90, v1), corner<N>(10, 20, v2), corner<N>(80, 30, v4)});
}

Trace gouraud() {
    return chapters_triangle<1>({0.9}, {0.2}, {0.5});
}

TEST(Oracle, GOUR_a_EndsOfTheScanline) {
    const auto trace = gouraud();
    const auto& active = scanline(trace, 60).active;
    ASSERT_EQ(active.size(), 2u);
    EXPECT_NEAR(active[0].x - 0.5, 27.1428571, 1e-7);
    EXPECT_NEAR(active[1].x - 0.5, 60.0, tolerance);
    EXPECT_NEAR(active[0].values[0], 0.6, tolerance);
    EXPECT_NEAR(active[1].values[0], 0.7, tolerance);
}

TEST(Oracle, GOUR_b_IntensityInTheSpan) {
    EXPECT_NEAR(value_at(gouraud(), 45, 60, 0), 0.654347826, tolerance);
}

TEST(Oracle, GOUR_c_MisprintedWeightsAreNotUsed) {
    EXPECT_GT(std::abs(value_at(gouraud(), 45, 60, 0) - 0.645652174), 0.008);
}

TEST(Oracle, GOUR_d_Increments) {
    const auto trace = gouraud();
    const auto& row = scanline(trace, 60);
    EXPECT_NEAR(row.active[0].steps[0], 0.01, tolerance);
    EXPECT_NEAR(row.active[1].steps[0], 0.00666666667, tolerance);
    EXPECT_NEAR(row.spans[0].steps[0], 0.00304347826, tolerance);
}

TEST(Oracle, GOUR_e_NextScanlineByOneAddition) {
    const auto trace = gouraud();
    const auto& here = scanline(trace, 60).active;
    const auto& next = scanline(trace, 61).active;
    EXPECT_NEAR(next[0].values[0], 0.61, tolerance);
    EXPECT_NEAR(next[1].values[0], 0.706666667, tolerance);
    EXPECT_NEAR(here[0].values[0] + here[0].steps[0], next[0].values[0], 1e-14);
    EXPECT_NEAR(here[1].values[0] + here[1].steps[0], next[1].values[0], 1e-14);
}

TEST(Oracle, GOUR_f_NextPixelByOneAddition) {
    EXPECT_NEAR(value_at(gouraud(), 46, 60, 0), 0.657391304, tolerance);
}

/// The triangle with its corners on pixel centres and its left edge down a column of them: there
/// the span's first value is I_a, and what would be added at x_b makes I_b.
TEST(Bilinear, AtTheEndsOfASpanAreTheEdgesValues) {
    const auto trace =
        traced<1>({corner<1>(10, 0, {0.9}), corner<1>(10, 80, {0.2}), corner<1>(90, 80, {0.5})});
    for (const int y : {20, 40, 60}) {
        const auto& active = scanline(trace, y).active;
        ASSERT_EQ(active.size(), 2u);
        ASSERT_NEAR(active[1].x - 0.5, 10 + y, tolerance);
        EXPECT_NEAR(value_at(trace, 10, y, 0), active[0].values[0], tolerance);
        EXPECT_NEAR(value_at(trace, 10 + y, y, 0), active[1].values[0], tolerance);
        EXPECT_NEAR(active[0].values[0], 0.9 - 0.7 * y / 80, tolerance);
        EXPECT_NEAR(active[1].values[0], 0.9 - 0.4 * y / 80, tolerance);
    }
}

constexpr double half_root = 1.0 / std::numbers::sqrt2;

Trace phong() {
    return chapters_triangle<3>({0, 0, 1}, {-half_root, 0, half_root}, {half_root, 0, half_root});
}

void expect_near(const std::vector<double>& value, const Values<3>& expected) {
    ASSERT_EQ(value.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

std::vector<double> normal_at(int x, int y) {
    const auto trace = phong();
    return {value_at(trace, x, y, 0), value_at(trace, x, y, 1), value_at(trace, x, y, 2)};
}

TEST(Oracle, PHSH_a_NormalOnTheLeftEdge) {
    expect_near(scanline(phong(), 60).active[0].values, {-0.303045763, 0, 0.874474335});
}

TEST(Oracle, PHSH_b_NormalOnTheRightEdge) {
    expect_near(scanline(phong(), 60).active[1].values, {0.353553391, 0, 0.853553391});
}

TEST(Oracle, PHSH_c_NormalInTheSpan) {
    expect_near(normal_at(45, 60), {0.0538016029, 0, 0.863104256});
}

TEST(Oracle, PHSH_d_NormalisedAtThePixel) {
    const auto n = normal_at(45, 60);
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    EXPECT_NEAR(length, 0.864779492, tolerance);
    expect_near({n[0] / length, n[1] / length, n[2] / length}, {0.0622142447, 0, 0.998062818});
}

TEST(Oracle, PHSH_e_NormalsIncrement) {
    expect_near(scanline(phong(), 60).spans[0].steps, {0.0199834525, 0, -0.000636724389});
}

/// Light and eye straight ahead: k_a I_a = 0.1, k_d = 0.5, k_s = 0.4, n = 50.
double lit_straight_ahead(double n_z) {
    return 0.1 + 0.5 * n_z + 0.4 * std::pow(n_z, 50);
}

TEST(Oracle, PHSH_f_PhongIlluminatesTheInterpolatedNormal) {
    const auto n = normal_at(45, 60);
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    EXPECT_NEAR(lit_straight_ahead(n[2] / length), 0.962070851, 1e-7);
}

TEST(Oracle, PHSH_h_GouraudInterpolatesTheIlluminatedCorners) {
    const double side = lit_straight_ahead(half_root);
    EXPECT_NEAR(side, 0.453553403, 1e-9);  // PHSH.g
    const auto trace = chapters_triangle<1>({1.0}, {side}, {side});
    EXPECT_NEAR(value_at(trace, 45, 60, 0), 0.744595612, tolerance);
}

/// A square whose left corners have one value and whose right corners another.
template <int N>
Trace left_to_right(const Values<N>& left, const Values<N>& right) {
    return traced<N>({corner<N>(0, 0, left), corner<N>(100, 0, right), corner<N>(100, 100, right),
                      corner<N>(0, 100, left)});
}

TEST(Oracle, HILI_a_GouraudLosesAHighlightBetweenCorners) {
    const double c30 = std::numbers::sqrt3 / 2.0;
    const double at_corners = 0.5 * (c30 + std::pow(c30, 50));
    EXPECT_NEAR(value_at(left_to_right<1>({at_corners}, {at_corners}), 50, 50, 0), 0.433388974,
                tolerance);
}

TEST(Oracle, HILI_b_PhongKeepsAHighlightBetweenCorners) {
    const double c30 = std::numbers::sqrt3 / 2.0;
    const auto trace = left_to_right<3>({-0.5, 0.0, c30}, {0.5, 0.0, c30});
    EXPECT_NEAR(value_at(trace, 50, 50, 0), 0.0, tolerance);
    EXPECT_NEAR(value_at(trace, 50, 50, 2), c30, tolerance);  // straight ahead once normalised
}

struct Vector {
    double x, y;
};

Vector turned(Vector p, double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    return {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a)};
}

/// The bilinear value at a point of the square [-1, 1]² with corner values 1, 0, 1, 0, or of a part
/// of it with some of its corners, turned. The point is moved onto a pixel centre; the square is
/// large, so that snapping does not count.
double turned_square_at(Vector point, double degrees, const std::vector<std::size_t>& corners) {
    constexpr double scale = 4000.0;
    constexpr int middle = 8000;
    const Vector p = turned(point, degrees);
    const std::array<Vector, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::vector<ScreenVertex<1>> polygon;
    for (const std::size_t i : corners) {
        const Vector q = turned(square[i], degrees);
        polygon.push_back(corner<1>(middle + (q.x - p.x) * scale, middle + (q.y - p.y) * scale,
                                    {i % 2 == 0 ? 1.0 : 0.0}));
    }
    return value_at(traced(polygon), middle, middle, 0);
}

double turned_square_at(Vector point, double degrees) {
    return turned_square_at(point, degrees, {0, 1, 2, 3});
}

TEST(Oracle, DEFE_d_CentreOfASquareChangesWithItsOrientation) {
    EXPECT_NEAR(turned_square_at({0, 0}, 0), 0.5, 1e-8);
    EXPECT_NEAR(turned_square_at({0, 0}, 45), 0.0, 1e-6);
    EXPECT_NEAR(turned_square_at({0, 0}, -45), 1.0, 1e-6);
}

TEST(Oracle, DEFE_e_CentreOfTheSquareAtEachRotation) {
    const std::array<double, 5> degrees{0, 10, 20, 30, 44};
    const std::array<double, 5> expected{0.5, 0.41183651, 0.318014883, 0.211324865, 0.0171556126};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(turned_square_at({0, 0}, degrees[i]), expected[i], 1e-6) << degrees[i];
}

TEST(Oracle, DEFE_f_AnotherPointOfTheSquareAtEachRotation) {
    EXPECT_NEAR(turned_square_at({0.5, 0.25}, 0), 0.5625, 1e-6);
    EXPECT_NEAR(turned_square_at({0.5, 0.25}, 20), 0.426011162, 1e-6);
    EXPECT_NEAR(turned_square_at({0.5, 0.25}, 40), 0.375, 1e-6);
}

TEST(Bilinear, OfATriangleOfTheSquareIsTheSameHoweverItIsTurned) {
    for (const double degrees : {-45.0, 0.0, 10.0, 20.0, 40.0, 45.0, 90.0, 137.0})
        EXPECT_NEAR(turned_square_at({0.5, 0.25}, degrees, {0, 1, 2}), 0.875, 1e-6) << degrees;
}

// Laws.

/// Whether all values at both ends of a span (and so, being linear, all between) lie in the range
/// of the polygon's corners.
template <int N>
testing::AssertionResult within_corners(const std::vector<ScreenVertex<N>>& polygon,
                                        const Span<N>& span) {
    const auto check = [&](const Ramp& ramp, const std::vector<std::int64_t>& values) {
        const int last = span.x_end - span.x_begin - 1;
        return std::max(laws::beyond(ramp.get(), values),
                        laws::beyond(laws::ahead(ramp, last).get(), values));
    };
    std::int64_t worst = check(span.ramps.depth, laws::corner_depths(polygon));
    for (std::size_t k = 0; k < N; ++k) {
        worst =
            std::max(worst, check(span.ramps.attributes[k], laws::corner_attributes(polygon, k)));
    }
    if (worst == 0) return testing::AssertionSuccess();
    return testing::AssertionFailure() << worst << " units beyond on scanline " << span.y << " of "
                                       << testing::PrintToString(laws::points_of(polygon));
}

TEST(Bilinear, NeverLeavesTheRangeOfTheCorners) {
    Random random(1);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::million; ++i) {
        const int extent = random.one_in(2) ? 8 * subpixels : 2 * subpixels;
        const auto polygon =
            laws::with_random_values<2>(laws::random_polygon(random, extent), random);
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear))
            ASSERT_TRUE(within_corners(polygon, span));
    }
}

TEST(Bilinear, NeverLeavesTheRangeOfTheCornersOnTheLargestPicture) {
    Random random(2);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::cases(300); ++i) {
        const auto polygon =
            laws::with_random_values<2>(laws::random_polygon(random, max_size * subpixels), random);
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear))
            ASSERT_TRUE(within_corners(polygon, span));
    }
}

TEST(Bilinear, IsExactOnTheThinnestTriangles) {
    Random random(3);
    PolygonFiller<1> filler;
    const ScreenPoint centre = laws::centre_of(max_size / 2, max_size / 2);
    for (int i = 0; i < laws::cases(3000); ++i) {
        const auto needle =
            laws::with_random_values<1>(laws::random_needle(random, centre), random);
        const auto spans = spans_of(filler, needle, Interpolation::bilinear);
        ASSERT_EQ(spans.size(), 1u);  // the centre, and nothing else
        ASSERT_EQ(spans[0].x_end, max_size / 2 + 1);
        double mean = 0.0;
        for (const auto& corner : needle)
            mean += corner.attributes[0] / 3.0;
        ASSERT_NEAR(laws::units(spans[0].ramps.attributes[0].value), mean, 0.5)
            << testing::PrintToString(laws::points_of(needle));
    }
}

/// Depth and attributes at both ends of a span against the textbook's rule in long double.
template <int N>
void expect_textbook(const std::vector<ScreenVertex<N>>& polygon, const Span<N>& span) {
    const Points points = laws::points_of(polygon);
    const auto check = [&](const Ramp& ramp, const std::vector<std::int64_t>& values) {
        for (const int x : {span.x_begin, span.x_end - 1}) {
            const auto expected = laws::bilinear_value(points, values, x, span.y);
            ASSERT_NEAR(laws::units(laws::ahead(ramp, x - span.x_begin).value),
                        static_cast<double>(expected), 0.5)
                << testing::PrintToString(points) << " at " << x << ", " << span.y;
        }
    };
    check(span.ramps.depth, laws::corner_depths(polygon));
    for (std::size_t k = 0; k < N; ++k)
        check(span.ramps.attributes[k], laws::corner_attributes(polygon, k));
}

/// Polygons without corners on centre lines: there two edges may share a crossing, and the
/// reference would have to break the tie.
Points between_centre_lines(Points polygon) {
    for (auto& p : polygon)
        p.y |= 1;
    return polygon;
}

TEST(Bilinear, IsTheTextbooksRuleWithinHalfAUnit) {
    Random random(4);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(200'000); ++i) {
        const Points shape = random.one_in(2) ? laws::random_star(random, 7 * subpixels)
                                              : laws::random_convex(random, 7 * subpixels);
        const auto polygon = laws::with_random_values<1>(between_centre_lines(shape), random);
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear)) {
            expect_textbook(polygon, span);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

TEST(Bilinear, IsTheTextbooksRuleWithinHalfAUnitOnTheLargestPicture) {
    Random random(5);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(100); ++i) {
        const auto polygon = laws::with_random_values<1>(
            between_centre_lines(laws::random_star(random, max_size * subpixels - 1)), random);
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear)) {
            expect_textbook(polygon, span);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

/// The bound that `Bilinear` states, in units.
double stated_bound(int scanlines, int pixels) {
    return laws::units(1) * ((scanlines + pixels) / 2.0 + 2.0);
}

/// On a triangle the rule is the plane through its corners, which the test knows exactly.
void expect_plane(PolygonFiller<1>& filler, const std::vector<ScreenVertex<1>>& triangle) {
    const Points points = laws::points_of(triangle);
    const auto values = laws::corner_attributes(triangle, 0);
    const auto depths = laws::corner_depths(triangle);
    const auto spans = spans_of(filler, triangle, Interpolation::bilinear);
    for (const auto& span : spans) {
        for (const int x : {span.x_begin, span.x_end - 1}) {
            const int pixels = x - span.x_begin;
            const double bound = stated_bound(span.y - first_centre(laws::top_of(points)), pixels);
            const auto error = [&](const Ramp& ramp, const std::vector<std::int64_t>& corners) {
                const auto value = laws::ahead(ramp, pixels).value;
                return std::abs(laws::error_from_plane(value, points, corners, x, span.y));
            };
            ASSERT_LE(error(span.ramps.attributes[0], values), bound)
                << testing::PrintToString(points);
            ASSERT_LE(error(span.ramps.depth, depths), bound) << testing::PrintToString(points);
        }
    }
}

TEST(Bilinear, IsThePlaneOnTrianglesWithinTheStatedBound) {
    Random random(6);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::million; ++i) {
        const Points points = random.one_in(4) ? laws::random_sliver(random, 30 * subpixels)
                                               : laws::random_triangle(random, 7 * subpixels);
        expect_plane(filler, laws::with_random_values<1>(points, random));
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Bilinear, IsThePlaneOnTrianglesWithinTheStatedBoundOnTheLargestPicture) {
    Random random(10);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(300); ++i) {
        const Points points = random.one_in(2)
                                  ? laws::random_sliver(random, max_size * subpixels)
                                  : laws::random_triangle(random, max_size * subpixels);
        expect_plane(filler, laws::with_random_values<1>(points, random));
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Bilinear, AddedUpPixelByPixelIsTheDirectValue) {
    Random random(7);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::cases(50'000); ++i) {
        const auto polygon =
            laws::with_random_values<2>(laws::random_polygon(random, 40 * subpixels), random);
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear)) {
            Ramps<2> stepped = span.ramps;
            for (int n = 0; n < span.x_end - span.x_begin; ++n, stepped.step()) {
                ASSERT_EQ(stepped.depth, laws::ahead(span.ramps.depth, n));
                ASSERT_EQ(stepped.attributes[1], laws::ahead(span.ramps.attributes[1], n));
            }
        }
    }
}

TEST(Bilinear, KnowsNoFirstCornerAndNoOrientation) {
    Random random(8);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::million / 2; ++i) {
        auto polygon =
            laws::with_random_values<2>(laws::random_star(random, 8 * subpixels), random);
        const auto spans = spans_of(filler, polygon, Interpolation::bilinear);
        std::rotate(polygon.begin(), polygon.begin() + 2, polygon.end());
        ASSERT_EQ(spans_of(filler, polygon, Interpolation::bilinear), spans);
        std::reverse(polygon.begin(), polygon.end());
        ASSERT_EQ(spans_of(filler, polygon, Interpolation::bilinear), spans);
    }
}

TEST(Bilinear, OfOneColourIsThatColourToTheBit) {
    Random random(9);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(200'000); ++i) {
        auto polygon =
            laws::with_random_values<1>(laws::random_polygon(random, 9 * subpixels), random);
        for (auto& corner : polygon)
            corner.attributes[0] = polygon.front().attributes[0];
        for (const auto& span : spans_of(filler, polygon, Interpolation::bilinear)) {
            ASSERT_EQ(span.ramps.attributes[0].get(), polygon.front().attributes[0]);
            ASSERT_EQ(span.ramps.attributes[0].step_size, 0);
        }
    }
}

}  // namespace
}  // namespace scanlight::raster
