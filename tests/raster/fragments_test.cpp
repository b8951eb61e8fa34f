#include "raster/fragments.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "raster/fill.h"
#include "tests/raster/filled.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster {
namespace {

using laws::Points;
using laws::Random;

constexpr int size = 16;
constexpr Viewport picture{size, size};

/// A run of pixels on scanline 0 at one depth.
Span<1> run(int x_begin, int x_end, Depth z, Attribute value) {
    Span<1> span{0, x_begin, x_end, {}};
    span.ramps.depth.value = std::int64_t{z} << ramp_bits;
    span.ramps.attributes[0].value = std::int64_t{value} << ramp_bits;
    return span;
}

struct Canvas {
    Plane<Depth> depth{picture, depth_clear};
    Plane<int> target{picture, 0};

    void draw(const Span<1>& span, int colour) {
        draw_span(span, depth, target, [colour](const Fragment<1>&) { return colour; });
    }
};

TEST(DrawSpan, KeepsTheNearest) {
    Canvas canvas;
    canvas.draw(run(2, 6, 500, 0), 1);
    canvas.draw(run(4, 8, 400, 0), 2);
    canvas.draw(run(0, 9, 450, 0), 3);
    const std::vector<int> expected{3, 3, 3, 3, 2, 2, 2, 2, 3, 0};
    for (int x = 0; x < 10; ++x)
        EXPECT_EQ(canvas.target.at(x, 0), expected[static_cast<std::size_t>(x)]) << x;
    EXPECT_EQ(canvas.depth.at(4, 0), 400);
    EXPECT_EQ(canvas.depth.at(9, 0), depth_clear);
    EXPECT_EQ(canvas.depth.at(4, 1), depth_clear);
}

TEST(DrawSpan, FirstWinsTies) {
    Canvas canvas;
    canvas.draw(run(0, 4, 500, 0), 1);
    canvas.draw(run(0, 4, 500, 0), 2);
    EXPECT_EQ(canvas.target.at(3, 0), 1);
}

TEST(DrawSpan, DrawsOnTheFarPlaneItself) {
    Canvas canvas;
    canvas.draw(run(0, 4, depth_far, 0), 1);
    EXPECT_EQ(canvas.target.at(0, 0), 1);
}

TEST(DrawSpan, ShadesOnlyWhatItStores) {
    Canvas canvas;
    canvas.draw(run(0, 4, 300, 0), 1);
    int shaded = 0;
    draw_span(run(2, 8, 500, 0), canvas.depth, canvas.target, [&shaded](const Fragment<1>&) {
        ++shaded;
        return 2;
    });
    EXPECT_EQ(shaded, 4);
}

TEST(DrawSpan, HandsOverPlaceDepthAndInterpolatedValues) {
    Canvas canvas;
    Span<1> span = run(3, 6, 1000, 1 << 28);
    span.ramps.depth.step_size = std::int64_t{10} << ramp_bits;
    span.ramps.attributes[0].step_size = std::int64_t{1 << 27} << ramp_bits;
    int x = 3;
    draw_span(span, canvas.depth, canvas.target, [&x](const Fragment<1>& f) {
        EXPECT_EQ(f.x, x);
        EXPECT_EQ(f.y, 0);
        EXPECT_EQ(f.depth, 1000 + 10 * (x - 3));
        EXPECT_EQ(f.attributes[0], 0.5f + 0.25f * static_cast<float>(x - 3));
        return ++x;
    });
    EXPECT_EQ(x, 6);
    EXPECT_EQ(canvas.depth.at(5, 0), 1020);
}

using Polygon = std::vector<ScreenVertex<1>>;

Polygon random_layer(Random& random) {
    return laws::with_random_values<1>(laws::random_polygon(random, size * subpixels), random);
}

TEST(DrawSpan, NearestStaysInAnyOrder) {
    Random random(1);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(20'000); ++i) {
        std::vector<Polygon> layers;
        for (int k = 0; k < 4; ++k)
            layers.push_back(random_layer(random));
        const auto drawn = [&] {
            Canvas canvas;
            for (const auto& layer : layers) {
                filler.fill(layer, Interpolation::planar,
                            [&](const Span<1>& s) { canvas.draw(s, 1); });
            }
            return canvas.depth;
        };
        const auto depth = drawn();
        std::reverse(layers.begin(), layers.end());
        ASSERT_EQ(drawn(), depth);
    }
}

TEST(CountSpan, LeavesDepthAloneAndCountsWhereAsked) {
    Plane<Depth> depth(picture, depth_clear);
    Plane<std::int32_t> stencil(picture, 0);
    depth.at(2, 0) = 100;
    depth.at(3, 0) = 400;
    count_span(run(1, 5, 400, 0), StencilCount::where_nearer, 5, depth, stencil);
    EXPECT_EQ(stencil.at(1, 0), 5);
    EXPECT_EQ(stencil.at(2, 0), 0);
    EXPECT_EQ(stencil.at(3, 0), 0);  // equal is not nearer
    count_span(run(1, 5, 400, 0), StencilCount::where_not_nearer, -1, depth, stencil);
    EXPECT_EQ(stencil.at(1, 0), 5);
    EXPECT_EQ(stencil.at(2, 0), -1);
    EXPECT_EQ(stencil.at(3, 0), -1);
    EXPECT_EQ(depth.at(2, 0), 100);
}

TEST(CountSpan, CountsTo300AndBack) {
    Plane<Depth> depth(picture, depth_clear);
    Plane<std::int32_t> stencil(picture, 0);
    for (int i = 0; i < 300; ++i)
        count_span(run(0, 3, 7, 0), StencilCount::where_nearer, 1, depth, stencil);
    EXPECT_EQ(stencil.at(2, 0), 300);
    for (int i = 0; i < 300; ++i)
        count_span(run(0, 3, 7, 0), StencilCount::where_nearer, -1, depth, stencil);
    EXPECT_EQ(stencil, Plane<std::int32_t>(picture, 0));
}

/// Something to test depth against: random polygons drawn.
Plane<Depth> random_depths(Random& random, PolygonFiller<1>& filler) {
    Canvas canvas;
    for (int k = 0; k < 4; ++k) {
        filler.fill(random_layer(random), Interpolation::planar,
                    [&](const Span<1>& s) { canvas.draw(s, 1); });
    }
    return canvas.depth;
}

void count(PolygonFiller<1>& filler, const Polygon& polygon, StencilCount where, int change,
           const Plane<Depth>& depth, Plane<std::int32_t>& stencil) {
    filler.fill(polygon, Interpolation::planar,
                [&](const Span<1>& span) { count_span(span, where, change, depth, stencil); });
}

TEST(CountSpan, NearerAndNotNearerAreAllPixelsOnce) {
    Random random(2);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(10'000); ++i) {
        const auto depth = random_depths(random, filler);
        const auto polygon = random_layer(random);
        Plane<std::int32_t> both(picture, 0);
        count(filler, polygon, StencilCount::where_nearer, 1, depth, both);
        count(filler, polygon, StencilCount::where_not_nearer, 1, depth, both);
        laws::Counts covered = laws::no_counts(size);
        laws::Counter().add(polygon, covered);
        ASSERT_EQ(both, covered);
    }
}

TEST(CountSpan, DepthPassEqualsDepthFailForClosedVolumes) {
    Random random(3);
    PolygonFiller<1> filler;
    for (int i = 0; i < laws::cases(10'000); ++i) {
        const auto depth = random_depths(random, filler);
        Plane<std::int32_t> pass(picture, 0);
        Plane<std::int32_t> fail(picture, 0);
        for (int volume = 0; volume < 3; ++volume) {
            // A front and a back with the same outline; no matter which is nearer.
            const Points outline = laws::random_polygon(random, size * subpixels);
            const auto front = laws::with_random_values<1>(outline, random);
            const auto back = laws::with_random_values<1>(outline, random);
            count(filler, front, StencilCount::where_nearer, 1, depth, pass);
            count(filler, back, StencilCount::where_nearer, -1, depth, pass);
            count(filler, back, StencilCount::where_not_nearer, 1, depth, fail);
            count(filler, front, StencilCount::where_not_nearer, -1, depth, fail);
        }
        ASSERT_EQ(pass, fail);
    }
}

}  // namespace
}  // namespace scanlight::raster
