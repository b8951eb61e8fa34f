#include "raster/trace.h"

#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"

namespace scanlight::raster {
namespace {

/// Corners on the centres of pixels (1, 0), (1, 4) and (5, 4); from 0.25 to 0.75 downwards, and to
/// 1.75 on the right.
std::vector<ScreenVertex<1>> triangle() {
    constexpr Attribute quarter = 1 << 27;
    return {{384, 128, 0, {quarter}},
            {384, 1152, depth_far, {3 * quarter}},
            {1408, 1152, depth_far, {7 * quarter}}};
}

Trace traced(Interpolation rule) {
    Trace trace;
    PolygonFiller<1> filler;
    filler.fill(
        triangle(), rule, [](const Span<1>&) {}, Tracer<1>(trace));
    return trace;
}

TEST(Tracer, WritesTheEdgeTableInTheTextbooksUnits) {
    const auto trace = traced(Interpolation::bilinear);
    ASSERT_EQ(trace.edge_table.size(), 2u);
    const auto& wall = trace.edge_table[0];
    EXPECT_EQ(wall.index, 0u);
    EXPECT_EQ(wall.y_begin, 0);
    EXPECT_EQ(wall.y_end, 4);
    EXPECT_EQ(wall.x, 1.5);
    EXPECT_EQ(wall.dx, 0.0);
    EXPECT_EQ(wall.z, 0.0);
    EXPECT_NEAR(wall.dz, 0.25, 1e-12);
    EXPECT_EQ(wall.values[0], 0.25);
    EXPECT_EQ(wall.steps[0], 0.125);
    const auto& slope = trace.edge_table[1];
    EXPECT_EQ(slope.index, 2u);
    EXPECT_EQ(slope.dx, 1.0);
    EXPECT_EQ(slope.steps[0], 0.375);
}

TEST(Tracer, WritesEachScanlinesActiveEdgesAndSpans) {
    const auto trace = traced(Interpolation::bilinear);
    ASSERT_EQ(trace.scanlines.size(), 4u);
    EXPECT_TRUE(trace.scanlines[0].spans.empty());  // the tip: no pixel between equal crossings
    const auto& row = trace.scanlines[2];
    EXPECT_EQ(row.y, 2);
    ASSERT_EQ(row.active.size(), 2u);
    EXPECT_EQ(row.active[0].x, 1.5);
    EXPECT_EQ(row.active[1].x, 3.5);
    EXPECT_EQ(row.active[0].values[0], 0.5);
    EXPECT_EQ(row.active[1].values[0], 1.0);
    ASSERT_EQ(row.spans.size(), 1u);
    EXPECT_EQ(row.spans[0].x_begin, 1);
    EXPECT_EQ(row.spans[0].x_end, 3);
    EXPECT_EQ(row.spans[0].values[0], 0.5);
    EXPECT_EQ(row.spans[0].steps[0], 0.25);
    EXPECT_NEAR(row.spans[0].z, 0.5, 1e-9);
    EXPECT_EQ(row.spans[0].dz, 0.0);
}

TEST(Tracer, SeesTheSpansOfAPlaneEquationToo) {
    const auto bilinear = traced(Interpolation::bilinear);
    const auto planar = traced(Interpolation::planar);
    ASSERT_EQ(planar.scanlines.size(), bilinear.scanlines.size());
    for (std::size_t i = 0; i < planar.scanlines.size(); ++i) {
        EXPECT_EQ(planar.scanlines[i].y, bilinear.scanlines[i].y);
        ASSERT_EQ(planar.scanlines[i].spans.size(), bilinear.scanlines[i].spans.size());
        for (std::size_t k = 0; k < planar.scanlines[i].spans.size(); ++k) {
            const auto& a = planar.scanlines[i].spans[k];
            const auto& b = bilinear.scanlines[i].spans[k];
            EXPECT_EQ(a.x_begin, b.x_begin);
            EXPECT_EQ(a.x_end, b.x_end);
            // Along the edges a span of one pixel takes no step.
            EXPECT_EQ(b.steps[0], b.x_end - b.x_begin > 1 ? a.steps[0] : 0.0);
            EXPECT_EQ(a.values[0], b.values[0]);
        }
    }
}

}  // namespace
}  // namespace scanlight::raster
