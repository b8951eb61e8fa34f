// What polygons cover: laws of the edge table, the active edges and the walk together.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"
#include "tests/raster/filled.h"
#include "tests/raster/random_polygons.h"
#include "tests/raster/reference_coverage.h"
#include "tests/raster/tilings.h"

namespace scanlight::raster {
namespace {

using laws::Counter;
using laws::Counts;
using laws::Points;
using laws::Random;
using laws::spans_of;
using laws::Tiling;

constexpr int size = 8;  // pixels: small pictures, many polygons
constexpr int extent = size * subpixels;

/// Calls `visit(column, row)` for each pixel of a small picture.
template <class Visit>
void for_each_pixel(const Counts& counts, Visit&& visit) {
    for (int row = 0; row < counts.height(); ++row) {
        for (int column = 0; column < counts.width(); ++column)
            visit(column, row);
    }
}

testing::AssertionResult equals_reference(const Counts& counts, const Points& polygon) {
    auto result = testing::AssertionSuccess();
    for_each_pixel(counts, [&](int column, int row) {
        const int expected = laws::covers(polygon, column, row) ? 1 : 0;
        if (counts.at(column, row) == expected) return;
        result = testing::AssertionFailure()
                 << "pixel " << column << ", " << row << " covered " << counts.at(column, row)
                 << " times, not " << expected << ", by " << testing::PrintToString(polygon);
    });
    return result;
}

Counts counted(Counter& counter, const Points& polygon) {
    Counts counts = laws::no_counts(size);
    counter.add(polygon, counts);
    return counts;
}

TEST(Coverage, EqualsTheExactReference) {
    Random random(1);
    Counter counter;
    for (int i = 0; i < laws::million; ++i) {
        const Points polygon = laws::random_polygon(random, extent);
        ASSERT_TRUE(equals_reference(counted(counter, polygon), polygon));
    }
}

TEST(Coverage, OfTrianglesEqualsEdgeFunctionsWithTheTopLeftRule) {
    Random random(2);
    Counter counter;
    for (int i = 0; i < laws::million; ++i) {
        const int reach = random.one_in(2) ? extent : 3 * subpixels;
        const Points triangle = laws::random_triangle(random, reach);
        const Counts counts = counted(counter, triangle);
        bool equal = true;
        for_each_pixel(counts, [&](int column, int row) {
            const bool inside = laws::covers_by_edge_functions(triangle, column, row);
            equal = equal && counts.at(column, row) == (inside ? 1 : 0);
        });
        ASSERT_TRUE(equal) << testing::PrintToString(triangle);
    }
}

/// The spans of one row as the reference has them: the ceilings of all crossings, in pairs.
std::vector<int> exact_ends(const Points& polygon, int row) {
    const SubPixel line = row * subpixels + half_pixel;
    std::vector<int> ends;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        ScreenPoint top = polygon[i];
        ScreenPoint bottom = polygon[(i + 1) % polygon.size()];
        if (top.y > bottom.y) std::swap(top, bottom);
        if (line < top.y || line >= bottom.y) continue;
        const __int128 height = __int128{subpixels} * (bottom.y - top.y);
        const __int128 n = __int128{top.x - half_pixel} * (bottom.y - top.y) +
                           __int128{bottom.x - top.x} * (line - top.y);
        const __int128 whole = n / height;
        ends.push_back(static_cast<int>(whole + (whole * height < n ? 1 : 0)));
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

void expect_exact_rows(const Points& polygon) {
    const auto spans = spans_of(laws::without_values<0>(polygon), Interpolation::bilinear);
    std::size_t next = 0;
    for (int row = 0; row < max_size; ++row) {
        const auto ends = exact_ends(polygon, row);
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
            if (ends[k] == ends[k + 1]) continue;
            ASSERT_LT(next, spans.size());
            ASSERT_EQ(spans[next].y, row);
            ASSERT_EQ(spans[next].x_begin, ends[k]) << testing::PrintToString(polygon);
            ASSERT_EQ(spans[next].x_end, ends[k + 1]) << testing::PrintToString(polygon);
            ++next;
        }
    }
    ASSERT_EQ(next, spans.size());
}

TEST(Coverage, IsExactOverTheLargestPicture) {
    Random random(3);
    for (int i = 0; i < laws::cases(500); ++i) {
        expect_exact_rows(laws::random_polygon(random, max_size * subpixels));
        if (HasFatalFailure()) return;
    }
}

testing::AssertionResult fills_its_outline_once(Counter& counter, const Tiling& tiling, int side) {
    Counts counts = laws::no_counts(side);
    for (const auto& tile : tiling.tiles)
        counter.add(tile, counts);
    return equals_reference(counts, tiling.outline);
}

TEST(SharedEdges, OfFansAboutAPointFillEachPixelOnce) {
    Random random(4);
    Counter counter;
    for (int tiles = 0; tiles < laws::million;) {
        const Tiling fan = laws::random_fan(random, extent);
        ASSERT_TRUE(fills_its_outline_once(counter, fan, size));
        tiles += static_cast<int>(fan.tiles.size());
    }
}

TEST(SharedEdges, OfStripsFillEachPixelOnce) {
    Random random(5);
    Counter counter;
    for (int tiles = 0; tiles < laws::million;) {
        const Tiling strip = laws::random_strip(random, extent);
        ASSERT_TRUE(fills_its_outline_once(counter, strip, size));
        tiles += static_cast<int>(strip.tiles.size());
    }
}

void expect_grids_fill_once(laws::Cut cut, std::uint32_t seed) {
    Random random(seed);
    Counter counter;
    for (int tiles = 0; tiles < laws::million;) {
        const int side = random.between(4, 24);
        const int cells = random.between(1, 12);
        for (int step = 0; step < 16; ++step) {
            const Tiling grid =
                laws::random_grid(random, side * subpixels, cells, cut, laws::rotation(step));
            ASSERT_TRUE(fills_its_outline_once(counter, grid, side));
            tiles += static_cast<int>(grid.tiles.size());
        }
    }
}

TEST(SharedEdges, OfQuadGridsIn16RotationsFillEachPixelOnce) {
    expect_grids_fill_once(laws::Cut::none, 6);
}

TEST(SharedEdges, OfTriangulatedGridsIn16RotationsFillEachPixelOnce) {
    expect_grids_fill_once(laws::Cut::random, 7);
}

TEST(SharedEdges, OfDelaunayGridsIn16RotationsFillEachPixelOnce) {
    expect_grids_fill_once(laws::Cut::delaunay, 8);
}

TEST(Coverage, OfAPolygonIsTheUnionOfAnyTriangulation) {
    Random random(9);
    Counter counter;
    int triangulated = 0;
    for (int i = 0; i < laws::million; ++i) {
        const Points polygon = laws::random_polygon(random, extent);
        const Tiling tiling = laws::random_triangulation(random, polygon);
        if (tiling.tiles.empty()) continue;
        ++triangulated;
        Counts counts = laws::no_counts(size);
        for (const auto& tile : tiling.tiles)
            counter.add(tile, counts);
        ASSERT_EQ(counts, counted(counter, polygon)) << testing::PrintToString(polygon);
    }
    EXPECT_GT(triangulated, laws::million * 9 / 10);
}

TEST(Coverage, KnowsNoFirstCornerAndNoOrientation) {
    Random random(10);
    Counter counter;
    for (int i = 0; i < laws::million; ++i) {
        Points polygon = laws::random_polygon(random, extent);
        const Counts counts = counted(counter, polygon);
        const int turn = random.between(0, static_cast<int>(polygon.size()) - 1);
        std::rotate(polygon.begin(), polygon.begin() + turn, polygon.end());
        ASSERT_EQ(counted(counter, polygon), counts) << testing::PrintToString(polygon);
        std::reverse(polygon.begin(), polygon.end());
        ASSERT_EQ(counted(counter, polygon), counts) << testing::PrintToString(polygon);
    }
}

template <class Map>
Points mapped(const Points& polygon, Map&& map) {
    Points result;
    for (const auto& p : polygon)
        result.push_back(map(p));
    return result;
}

TEST(Coverage, IsMirroredButForCentresOnEdges) {
    Random random(11);
    Counter counter;
    for (int i = 0; i < laws::million; ++i) {
        const Points polygon = laws::random_polygon(random, extent);
        const Counts counts = counted(counter, polygon);
        const auto left = counted(counter, mapped(polygon, [](ScreenPoint p) {
                                      return ScreenPoint{extent - p.x, p.y};
                                  }));
        const auto down = counted(counter, mapped(polygon, [](ScreenPoint p) {
                                      return ScreenPoint{p.x, extent - p.y};
                                  }));
        const auto across = counted(counter, mapped(polygon, laws::transposed));
        bool symmetric = true;
        for_each_pixel(counts, [&](int column, int row) {
            const int here = counts.at(column, row);
            const bool same = here == left.at(size - 1 - column, row) &&
                              here == down.at(column, size - 1 - row) &&
                              here == across.at(row, column);
            symmetric = symmetric && (same || laws::on_boundary(polygon, column, row));
        });
        ASSERT_TRUE(symmetric) << testing::PrintToString(polygon);
    }
}

TEST(Coverage, AndValuesMoveWithThePolygonByWholePixels) {
    Random random(12);
    PolygonFiller<2> filler;
    for (int i = 0; i < laws::million; ++i) {
        auto polygon =
            laws::with_random_values<2>(laws::random_polygon(random, 6 * subpixels), random);
        const auto rule = random.one_in(2) ? Interpolation::planar : Interpolation::bilinear;
        auto expected = spans_of(filler, polygon, rule);
        const int right = random.between(0, max_size - 6);
        const int down = random.between(0, max_size - 6);
        for (auto& corner : polygon) {
            corner.x += right * subpixels;
            corner.y += down * subpixels;
        }
        for (auto& span : expected) {
            span.x_begin += right;
            span.x_end += right;
            span.y += down;
        }
        ASSERT_EQ(spans_of(filler, polygon, rule), expected);
    }
}

TEST(PolygonFiller, ScratchMemoryLeavesNoTrace) {
    Random random(13);
    PolygonFiller<1> used;
    for (int i = 0; i < laws::cases(100'000); ++i) {
        const auto polygon =
            laws::with_random_values<1>(laws::random_polygon(random, extent), random);
        const auto rule = random.one_in(2) ? Interpolation::planar : Interpolation::bilinear;
        ASSERT_EQ(spans_of(used, polygon, rule), spans_of(polygon, rule));
    }
}

/// A regular polygon of radius 1 about the middle of a picture of 2 x 2 `scale` pixels.
Points regular(int corners, double scale) {
    Points polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        polygon.push_back(
            {static_cast<SubPixel>(std::lrint((1.0 + std::cos(angle)) * scale * subpixels)),
             static_cast<SubPixel>(std::lrint((1.0 + std::sin(angle)) * scale * subpixels))});
    }
    return polygon;
}

/// How deep the pixels left out reach into the circle, in pixels of a circle of radius 200: what
/// one would measure on the picture.
double outline_error(int corners) {
    constexpr double scale = 4000.0;
    double nearest = scale;
    for (const auto& span :
         spans_of(laws::without_values<0>(regular(corners, scale)), Interpolation::bilinear)) {
        for (const int outside : {span.x_begin - 1, span.x_end}) {
            const double x = outside + 0.5 - scale;
            const double y = span.y + 0.5 - scale;
            nearest = std::min(nearest, std::sqrt(x * x + y * y));
        }
    }
    return (scale - nearest) * 200.0 / scale;
}

TEST(Oracle, DEFE_a_SilhouetteOfADiscDrawnAsAPolygon) {
    EXPECT_NEAR(outline_error(8), 15.2240935, 0.01);
    EXPECT_NEAR(outline_error(16), 3.84294392, 0.01);
    EXPECT_NEAR(outline_error(64), 0.240908759, 0.01);
}

}  // namespace
}  // namespace scanlight::raster
