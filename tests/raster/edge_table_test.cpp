#include "raster/edge_table.h"

#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "raster/active_edges.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster {
namespace {

using laws::Points;
using laws::Random;

/// An edge's own number, to see that values stay with their edge.
struct Mark {
    SubPixel top_y = 0;
    int steps = 0;
    void step() { step(1); }
    void step(int times) { steps += times; }
};

EdgeTable<Mark> table_of(const Points& points) {
    const auto polygon = laws::without_values<0>(points);
    EdgeTable<Mark> table;
    table.build(std::span(polygon), [](const auto& top, const auto&, int) {
        return Mark{top.y, 0};
    });
    return table;
}

Points in_pixels(const Points& pixels) {
    Points points;
    for (const auto& p : pixels)
        points.push_back({p.x * subpixels, p.y * subpixels});
    return points;
}

TEST(EdgeTable, HoldsTheEdgesOfAPolygonInTheOrderOfTheirBuckets) {
    // A house: roof from (4, 0) to (0, 4) and (8, 4), walls down to y = 10.
    const auto table = table_of(in_pixels({{4, 0}, {0, 4}, {0, 10}, {8, 10}, {8, 4}}));
    const auto edges = table.edges();
    ASSERT_EQ(edges.size(), 4u);  // the floor is horizontal

    const std::vector<std::uint32_t> indices{0, 4, 1, 3};
    const std::vector<int> begins{0, 0, 4, 4};
    const std::vector<int> ends{4, 4, 10, 10};
    const std::vector<double> xs{3.5, 4.5, 0.0, 8.0};  // on the first centre line
    const std::vector<double> dxs{-1.0, 1.0, 0.0, 0.0};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(edges[i].index, indices[i]);
        EXPECT_EQ(edges[i].y_begin, begins[i]);
        EXPECT_EQ(edges[i].y_end, ends[i]);
        EXPECT_EQ(edges[i].crossing.x(), xs[i]);
        EXPECT_EQ(edges[i].crossing.dx(), dxs[i]);
        EXPECT_EQ(edges[i].values.top_y, begins[i] * subpixels);
    }
    EXPECT_EQ(table.y_begin(), 0);
    EXPECT_EQ(table.y_end(), 10);
}

TEST(EdgeTable, LeavesOutEdgesBetweenTwoCentreLines) {
    EXPECT_TRUE(table_of({{0, 129}, {500, 384}, {900, 140}}).edges().size() == 0);
    EXPECT_FALSE(table_of({{0, 129}, {500, 385}, {900, 140}}).empty());
    EXPECT_FALSE(table_of({{0, 128}, {500, 384}, {900, 140}}).empty());
}

TEST(EdgeTable, OfNothingIsEmpty) {
    for (const auto& points : {Points{}, Points{{500, 500}}}) {
        const auto table = table_of(points);
        EXPECT_TRUE(table.empty());
        EXPECT_EQ(table.y_begin(), table.y_end());
    }
}

TEST(EdgeTable, ForgetsTheLastPolygon) {
    const auto large = laws::without_values<0>({{0, 0}, {9000, 0}, {0, 9000}});
    const auto none = laws::without_values<0>({});
    EdgeTable<Mark> table;
    const auto no_values = [](const auto&, const auto&, int) { return Mark{}; };
    table.build(std::span(large), no_values);
    table.build(std::span(none), no_values);
    EXPECT_TRUE(table.empty());
}

TEST(EdgeTable, CrossesEachScanlineAnEvenNumberOfTimes) {
    Random random(1);
    for (int i = 0; i < laws::million; ++i) {
        const Points polygon = laws::random_polygon(random, 12 * subpixels);
        const auto table = table_of(polygon);
        std::vector<int> crossings(13, 0);
        for (const auto& edge : table.edges()) {
            ASSERT_LT(edge.y_begin, edge.y_end);
            for (int y = edge.y_begin; y < edge.y_end; ++y)
                ++crossings[static_cast<std::size_t>(y)];
        }
        for (const int n : crossings)
            ASSERT_EQ(n % 2, 0) << testing::PrintToString(polygon);
    }
}

TEST(ActiveEdges, AdmitsABucketSortsItAndRetiresWhatEnds) {
    // An M: the valley between its tops starts two edges in one point.
    auto table = table_of(in_pixels({{0, 8}, {2, 0}, {4, 4}, {6, 0}, {8, 8}}));
    ActiveEdges<Mark> active;
    auto waiting = active.admit(table.edges(), 0);
    active.sort_by_x();
    ASSERT_EQ(active.edges().size(), 4u);
    EXPECT_TRUE(waiting.empty());
    const std::vector<std::uint32_t> order{0, 1, 2, 3};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(active.edges()[i]->index, order[i]);

    active.retire_before(4);
    active.step();
    ASSERT_EQ(active.edges().size(), 2u);
    EXPECT_EQ(active.edges()[0]->index, 0u);
    EXPECT_EQ(active.edges()[1]->index, 3u);
    EXPECT_EQ(active.edges()[1]->values.steps, 1);
}

TEST(ActiveEdges, LeavesTheBucketsOfLaterScanlinesWaiting) {
    auto table = table_of(in_pixels({{4, 0}, {0, 4}, {0, 10}, {8, 10}, {8, 4}}));
    ActiveEdges<Mark> active;
    auto waiting = active.admit(table.edges(), 0);
    EXPECT_EQ(waiting.size(), 2u);
    waiting = active.admit(waiting, 1);
    EXPECT_EQ(waiting.size(), 2u);
    waiting = active.admit(waiting, 4);
    EXPECT_TRUE(waiting.empty());
}

TEST(ActiveEdges, PairsThatEncloseNoCentreAreNoSpans) {
    auto table = table_of({{130, 0}, {140, 1000}, {380, 1000}});  // thin, between two columns
    ActiveEdges<Mark> active;
    active.admit(table.edges(), 0);
    active.sort_by_x();
    int pairs = 0;
    active.for_each_pair([&pairs](const auto&, const auto&) { ++pairs; });
    EXPECT_EQ(active.edges().size(), 2u);
    EXPECT_EQ(pairs, 0);
}

}  // namespace
}  // namespace scanlight::raster
