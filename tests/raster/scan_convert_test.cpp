#include "raster/scan_convert.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/raster/filled.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster {
namespace {

using laws::Points;
using laws::Random;
using laws::spans_of;

/// A picture of what a polygon covers: '#' and '.', rows from the top.
std::vector<std::string> picture_of(const Points& polygon, int width, int height) {
    std::vector<std::string> rows(static_cast<std::size_t>(height),
                                  std::string(static_cast<std::size_t>(width), '.'));
    for (const auto& span : spans_of(laws::without_values<0>(polygon), Interpolation::bilinear)) {
        for (int x = span.x_begin; x < span.x_end; ++x)
            rows[static_cast<std::size_t>(span.y)][static_cast<std::size_t>(x)] = '#';
    }
    return rows;
}

using Picture = std::vector<std::string>;

TEST(ScanConvert, TriangleWhoseRightEdgeRunsThroughCentresLeavesThemOut) {
    EXPECT_EQ(picture_of({{0, 0}, {1024, 0}, {0, 1024}}, 5, 5), (Picture{"###..",  //
                                                                         "##...",  //
                                                                         "#....",  //
                                                                         ".....",  //
                                                                         "....."}));
}

TEST(ScanConvert, TriangleWhoseLeftEdgeRunsThroughCentresTakesThem) {
    EXPECT_EQ(picture_of({{1024, 0}, {1024, 1024}, {0, 1024}}, 5, 5), (Picture{"...#.",  //
                                                                               "..##.",  //
                                                                               ".###.",  //
                                                                               "####.",  //
                                                                               "....."}));
}

TEST(ScanConvert, SquareFromCentreToCentreTakesTopAndLeftOnly) {
    EXPECT_EQ(picture_of({{128, 128}, {896, 128}, {896, 896}, {128, 896}}, 5, 5),
              (Picture{"###..",  //
                       "###..",  //
                       "###..",  //
                       ".....",  //
                       "....."}));
}

TEST(ScanConvert, PixelSizedSquareTakesOnePixelWhereverItLies) {
    for (int shift = 0; shift < 256; ++shift) {
        const Points square{
            {shift, shift}, {shift + 256, shift}, {shift + 256, shift + 256}, {shift, shift + 256}};
        const auto spans = spans_of(laws::without_values<0>(square), Interpolation::bilinear);
        ASSERT_EQ(spans.size(), 1u);
        EXPECT_EQ(spans[0].x_end - spans[0].x_begin, 1);
        EXPECT_EQ(spans[0].x_begin, shift <= 128 ? 0 : 1);
        EXPECT_EQ(spans[0].y, shift <= 128 ? 0 : 1);
    }
}

TEST(ScanConvert, ConcavePolygonHasSeveralSpansOnAScanline) {
    const Points w{{0, 0},   {256, 0}, {256, 768},  {512, 768},
                   {512, 0}, {768, 0}, {768, 1024}, {0, 1024}};
    EXPECT_EQ(picture_of(w, 4, 4), (Picture{"#.#.",  //
                                            "#.#.",  //
                                            "#.#.",  //
                                            "###."}));
}

TEST(ScanConvert, CrossingEdgesFillByTheEvenOddRule) {
    const Points bow_tie{{0, 0}, {1536, 1536}, {1536, 0}, {0, 1536}};
    EXPECT_EQ(picture_of(bow_tie, 6, 6), (Picture{".....#",  //
                                                  "#...##",  //
                                                  "##.###",  //
                                                  "##.###",  //
                                                  "#...##",  //
                                                  ".....#"}));
}

TEST(ScanConvert, PolygonsOfNoAreaCoverNothing) {
    EXPECT_TRUE(spans_of(laws::without_values<0>({}), Interpolation::planar).empty());
    EXPECT_TRUE(spans_of(laws::without_values<0>({{128, 128}}), Interpolation::planar).empty());
    for (const auto rule : {Interpolation::bilinear, Interpolation::planar}) {
        const auto line = laws::without_values<0>({{0, 0}, {1000, 2000}, {500, 1000}});
        EXPECT_TRUE(spans_of(line, rule).empty());
        const auto twice = laws::without_values<0>({{0, 0}, {1000, 2000}});
        EXPECT_TRUE(spans_of(twice, rule).empty());
    }
}

TEST(ScanConvert, FillsTheLargestPictureToItsLastPixel) {
    constexpr int end = max_size * subpixels;
    const auto all = laws::without_values<1>({{0, 0}, {end, 0}, {end, end}, {0, end}});
    int rows = 0;
    PolygonFiller<1> filler;
    filler.fill(all, Interpolation::bilinear, [&rows](const Span<1>& span) {
        ASSERT_EQ(span.y, rows);
        ASSERT_EQ(span.x_begin, 0);
        ASSERT_EQ(span.x_end, max_size);
        ++rows;
    });
    EXPECT_EQ(rows, max_size);
}

TEST(ScanConvert, EmitsFromTopToBottomAndLeftToRightWithoutOverlap) {
    Random random(1);
    PolygonFiller<0> filler;
    for (int i = 0; i < laws::cases(200'000); ++i) {
        const Points polygon = laws::random_polygon(random, 24 * subpixels);
        const auto spans =
            spans_of(filler, laws::without_values<0>(polygon), Interpolation::bilinear);
        for (std::size_t k = 0; k < spans.size(); ++k) {
            ASSERT_LT(spans[k].x_begin, spans[k].x_end);
            if (k == 0) continue;
            const bool below = spans[k].y > spans[k - 1].y;
            const bool right =
                spans[k].y == spans[k - 1].y && spans[k].x_begin >= spans[k - 1].x_end;
            ASSERT_TRUE(below || right) << testing::PrintToString(polygon);
        }
    }
}

/// Counts what it is told.
struct Audience {
    int tables = 0;
    std::vector<int> scanlines;
    std::vector<std::size_t> active;
    int spans = 0;

    template <class Values>
    void edge_table(const EdgeTable<Values>&) {
        ++tables;
    }
    template <class Values>
    void scanline(int y, const ActiveEdges<Values>& edges) {
        scanlines.push_back(y);
        active.push_back(edges.edges().size());
    }
    template <int N>
    void span(const Span<N>&) {
        ++spans;
    }
};

TEST(ScanConvert, ObserverSeesTheTableEachScanlineAndEachSpan) {
    const auto w = laws::without_values<1>(
        {{0, 256}, {256, 256}, {256, 768}, {512, 768}, {512, 0}, {768, 0}, {768, 1024}, {0, 1024}});
    for (const auto rule : {Interpolation::bilinear, Interpolation::planar}) {
        Audience audience;
        int emitted = 0;
        PolygonFiller<1> filler;
        filler.fill(
            w, rule, [&emitted](const Span<1>&) { ++emitted; }, audience);
        EXPECT_EQ(audience.tables, 1);
        EXPECT_EQ(audience.scanlines, (std::vector{0, 1, 2, 3}));
        EXPECT_EQ(audience.active, (std::vector<std::size_t>{2, 4, 4, 2}));
        EXPECT_EQ(audience.spans, 6);
        EXPECT_EQ(emitted, 6);
    }
}

TEST(ScanConvert, ObserverChangesNothing) {
    Random random(2);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const auto polygon =
            laws::with_random_values<1>(laws::random_polygon(random, 9 * subpixels), random);
        Audience audience;
        std::vector<Span<1>> seen;
        filler.fill(
            polygon, Interpolation::planar, [&seen](const Span<1>& s) { seen.push_back(s); },
            audience);
        ASSERT_EQ(seen, spans_of(filler, polygon, Interpolation::planar));
    }
}

}  // namespace
}  // namespace scanlight::raster
