#include "render/polygon_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

double area(const GridRegion& region) {
    double sum = 0.0;
    for (const GridOutline& outline : region)
        sum += signed_area(outline);
    return std::abs(sum);
}

GridOutline square(std::int64_t low, std::int64_t high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
}

GridOutline random_triangle(Random& random) {
    GridOutline triangle;
    for (int i = 0; i < 3; ++i) {
        const double x = random.between(-1.0, 1.0) * 0x1p28;
        const double y = random.between(-1.0, 1.0) * 0x1p28;
        triangle.push_back({std::llrint(x), std::llrint(y)});
    }
    return triangle;
}

TEST(PolygonClipping, LeavesAHole) {
    const GridRegion rest = uncovered(square(0, 100), {square(30, 40)});
    EXPECT_EQ(rest.size(), 2u);
    EXPECT_EQ(area(rest), 10000.0 - 100.0);
    EXPECT_EQ(area(covered(square(0, 100), {square(30, 40)})), 100.0);
}

TEST(PolygonClipping, OthersMayTurnEitherWayAndOverlap) {
    GridOutline turned = square(35, 60);
    std::ranges::reverse(turned);
    EXPECT_EQ(area(uncovered(square(0, 100), {square(30, 40), turned})),
              10000.0 - 100.0 - 625.0 + 25.0);
}

TEST(PolygonClipping, OfNeighboursLeavesNothingBetween) {
    const GridOutline left{{0, 0}, {50, 0}, {37, 100}, {0, 100}};
    const GridOutline right{{50, 0}, {100, 0}, {100, 100}, {37, 100}};
    EXPECT_TRUE(uncovered(square(0, 100), {left, right}).empty());
}

TEST(PolygonClipping, PartsAddUpToThePolygon) {
    Random random(5);
    double most_covered = 0.0;
    for (int i = 0; i < 300; ++i) {
        const GridOutline polygon = random_triangle(random);
        std::vector<GridOutline> others;
        for (int k = 1 + random.below(12); k > 0; --k)
            others.push_back(random_triangle(random));
        const double whole = std::abs(signed_area(polygon));
        const double hidden = area(covered(polygon, others));
        EXPECT_NEAR(area(uncovered(polygon, others)) + hidden, whole, 1e-7 * 0x1p58);
        most_covered = std::max(most_covered, hidden / whole);
    }
    EXPECT_GT(most_covered, 0.5);
}

}  // namespace
}  // namespace scanlight::render
