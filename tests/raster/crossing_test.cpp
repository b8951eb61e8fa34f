#include "raster/crossing.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/raster/cases.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster {
namespace {

using laws::Random;
using Wide = __int128;

constexpr int screen = max_size * subpixels;

/// A crossing as a rational number of pixels from the first column's centre, and its slope.
struct Exact {
    Wide numerator, denominator;  // positive denominator
    Wide slope_numerator, slope_denominator;

    Exact(ScreenPoint top, ScreenPoint bottom, int row)
        : numerator(Wide{top.x - half_pixel} * (bottom.y - top.y) +
                    Wide{bottom.x - top.x} * (row * subpixels + half_pixel - top.y)),
          denominator(Wide{subpixels} * (bottom.y - top.y)),
          slope_numerator(bottom.x - top.x),
          slope_denominator(bottom.y - top.y) {}

    int column() const {
        const Wide quotient = numerator / denominator;
        return static_cast<int>(quotient + (quotient * denominator < numerator ? 1 : 0));
    }
    /// How far it lies left of the centre of a column.
    double left_of_centre(int centre) const {
        return static_cast<double>(static_cast<long double>(centre * denominator - numerator) /
                                   static_cast<long double>(denominator));
    }
    bool left_of(const Exact& other) const {
        const Wide here = numerator * other.denominator;
        const Wide there = other.numerator * denominator;
        if (here != there) return here < there;
        return slope_numerator * other.slope_denominator <
               other.slope_numerator * slope_denominator;
    }
};

struct Line {
    ScreenPoint top, bottom;
    int first_row() const { return first_centre(top.y); }
    int end_row() const { return first_centre(bottom.y); }
};

/// An edge with at least one row, of any length up to the largest picture's height.
Line random_line(Random& random) {
    for (;;) {
        const int extent = random.one_in(3) ? screen : random.between(subpixels, 64 * subpixels);
        Line line{laws::random_point(random, extent), laws::random_point(random, extent)};
        if (line.top.y > line.bottom.y) std::swap(line.top, line.bottom);
        if (line.first_row() < line.end_row()) return line;
    }
}

TEST(Crossing, SteppedDownIsTheExactCeilingOnEveryRow) {
    Random random(1);
    int rows = 0;
    while (rows < 4 * laws::million) {
        const Line line = random_line(random);
        Crossing crossing(line.top, line.bottom, line.first_row());
        for (int row = line.first_row(); row < line.end_row(); ++row, ++rows) {
            const Exact exact(line.top, line.bottom, row);
            ASSERT_EQ(crossing.column(), exact.column()) << line.top << line.bottom << row;
            crossing.step();
        }
    }
}

TEST(Crossing, GapIsTheExactDistanceToTheColumnsCentre) {
    Random random(2);
    for (int i = 0; i < laws::million; ++i) {
        const Line line = random_line(random);
        const int row = random.between(line.first_row(), line.end_row() - 1);
        const Crossing crossing(line.top, line.bottom, row);
        const Exact exact(line.top, line.bottom, row);
        ASSERT_GE(crossing.gap(), 0.0);
        ASSERT_LT(crossing.gap(), 1.0);
        ASSERT_DOUBLE_EQ(crossing.gap(), exact.left_of_centre(exact.column()));
        ASSERT_GT(crossing.reach(), 0.0);
        ASSERT_LE(crossing.reach(), 1.0);
        ASSERT_DOUBLE_EQ(crossing.reach(), -exact.left_of_centre(exact.column() - 1));
    }
}

TEST(Crossing, StepsKeepTheGapExact) {
    Random random(3);
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const Line line = random_line(random);
        const int last = std::min(line.end_row() - 1, line.first_row() + 200);
        Crossing stepped(line.top, line.bottom, line.first_row());
        for (int row = line.first_row(); row < last; ++row)
            stepped.step();
        ASSERT_EQ(stepped.gap(), Crossing(line.top, line.bottom, last).gap());
    }
}

TEST(Crossing, ThroughACentreBelongsToThatColumn) {
    const Crossing crossing({128, 0}, {128 + 512, 512}, 0);  // through (256, 128), then one on
    EXPECT_EQ(crossing.column(), 1);
    EXPECT_EQ(crossing.gap(), 0.5);
    EXPECT_EQ(crossing.x(), 1.0);
    EXPECT_EQ(crossing.dx(), 1.0);

    const Crossing exact({0, 0}, {512, 512}, 0);  // through the first pixel's centre
    EXPECT_EQ(exact.column(), 0);
    EXPECT_EQ(exact.gap(), 0.0);
    EXPECT_EQ(exact.x(), 0.5);
}

TEST(Crossing, SpansTheLargestPictureBothWays) {
    Crossing falling({0, 0}, {screen, screen}, 0);
    Crossing rising({screen, 0}, {0, screen}, 0);
    for (int row = 0; row < max_size; ++row) {
        ASSERT_EQ(falling.column(), row);
        ASSERT_EQ(rising.column(), max_size - 1 - row);
        falling.step();
        rising.step();
    }
}

/// Edges through one point of the row: their crossings are equal or next to one another.
Line line_through(Random& random, ScreenPoint p, int reach) {
    const int dx = random.between(-reach, reach);
    const int up = random.between(0, reach);
    const int down = random.between(1, reach);
    const int wobble = random.between(-1, 1);
    return {{p.x - dx * up, p.y - up}, {p.x + dx * down + wobble, p.y + down}};
}

TEST(LeftOf, IsTheExactOrderOfCrossingsThenSlopes) {
    Random random(4);
    const int row = 5000;
    for (int i = 0; i < laws::million; ++i) {
        const ScreenPoint p{5000 * subpixels + random.between(0, 255),
                            row * subpixels + half_pixel};
        const int reach = random.one_in(2) ? 3 : 1000;
        const Line a = line_through(random, p, reach);
        const Line b = line_through(random, p, reach);
        const Crossing crossing_a(a.top, a.bottom, row);
        const Crossing crossing_b(b.top, b.bottom, row);
        const Exact exact_a(a.top, a.bottom, row);
        const Exact exact_b(b.top, b.bottom, row);
        ASSERT_EQ(left_of(crossing_a, crossing_b), exact_a.left_of(exact_b))
            << a.top << a.bottom << b.top << b.bottom;
        ASSERT_EQ(left_of(crossing_b, crossing_a), exact_b.left_of(exact_a));
    }
}

TEST(LeftOf, IsExactBetweenTheLongestEdges) {
    Random random(5);
    for (int i = 0; i < laws::million; ++i) {
        const auto steep = [&random](int x) {
            return Line{
                {std::clamp(x + random.between(-9, 9), 0, screen), random.between(0, 9)},
                {std::clamp(x + random.between(-9, 9), 0, screen), screen - random.between(0, 9)}};
        };
        const int x = random.between(0, screen);
        const Line a = steep(x);
        const Line b = steep(x);
        const int row = random.between(1, max_size - 2);
        ASSERT_EQ(left_of({a.top, a.bottom, row}, {b.top, b.bottom, row}),
                  Exact(a.top, a.bottom, row).left_of({b.top, b.bottom, row}))
            << a.top << a.bottom << b.top << b.bottom << row;
    }
}

TEST(LeftOf, IsAStrictWeakOrder) {
    Random random(6);
    const int row = 50;
    for (int i = 0; i < laws::cases(100'000); ++i) {
        std::vector<Crossing> c;
        for (int k = 0; k < 3; ++k) {
            const Line line = line_through(random, {12800, row * subpixels + half_pixel}, 2);
            c.emplace_back(line.top, line.bottom, row);
        }
        const auto tied = [](const Crossing& a, const Crossing& b) {
            return !left_of(a, b) && !left_of(b, a);
        };
        ASSERT_FALSE(left_of(c[0], c[0]));
        ASSERT_FALSE(left_of(c[0], c[1]) && left_of(c[1], c[0]));
        ASSERT_TRUE(left_of(c[0], c[2]) || !(left_of(c[0], c[1]) && left_of(c[1], c[2])));
        ASSERT_TRUE(tied(c[0], c[2]) || !(tied(c[0], c[1]) && tied(c[1], c[2])));
    }
}

}  // namespace
}  // namespace scanlight::raster
