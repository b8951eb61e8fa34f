#include "raster/count_triangle.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "raster/fragments.h"
#include "tests/raster/cases.h"

namespace scanlight::raster {
namespace {

constexpr Viewport size{150, 37};

/// Depths in steps a tile wide, so that some triangles lie behind all of some tiles.
Plane<Depth> stepped_depths(std::mt19937& random) {
    Plane<Depth> depth(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto step = static_cast<Depth>((x >> CountedBand::tile_bits) + 1) << 27;
            depth.at(x, y) = step + static_cast<Depth>(random() % 1000);
        }
    }
    return depth;
}

CountedTriangle random_triangle(std::mt19937& random) {
    CountedTriangle triangle;
    const auto below = [&](std::uint32_t end) { return static_cast<std::int32_t>(random() % end); };
    const bool is_sliver = random() % 2 == 0;
    for (auto& corner : triangle.corners) {
        corner.x = below(size.width * subpixels + 1);
        corner.y = below(size.height * subpixels + 1);
        corner.z = below(1u << 30);
    }
    if (is_sliver) {
        auto& [a, b, c] = triangle.corners;
        c.x = std::clamp(b.x + below(600) - 300, 0, size.width * subpixels);
        c.y = b.y;
    }
    triangle.count = below(9) - 4;
    return triangle;
}

std::vector<Depth> farthest_in_tiles(const Plane<Depth>& depth, Rows rows) {
    std::vector<Depth> farthest(size.width / (1 << CountedBand::tile_bits) + 1, 0);
    for (int y = rows.y_begin; y < rows.y_end; ++y) {
        for (int x = 0; x < size.width; ++x) {
            Depth& most = farthest[static_cast<std::size_t>(x >> CountedBand::tile_bits)];
            most = std::max(most, depth.at(x, y));
        }
    }
    return farthest;
}

// In the middle rows only, as a band has them.
TEST(TriangleCounter, CountsWhatTheWalkByTheWindingRuleCounts) {
    std::mt19937 random(3);
    const Rows rows{5, 32};
    const Plane<Depth> depth = stepped_depths(random);
    const auto farthest = farthest_in_tiles(depth, rows);
    TriangleCounter counter;
    PolygonFiller<0, FillRule::winding> filler;
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const CountedTriangle triangle = random_triangle(random);
        Plane<std::int32_t> expected(size, 0);
        filler.fill(
            triangle.corners, Interpolation::planar,
            [&](const Span<0>& span) {
                count_span(span, StencilCount::where_nearer, span.winding * triangle.count, depth,
                           expected);
            },
            NoObserver{}, rows);
        Plane<std::int32_t> counts(size, 0);
        counter.count(triangle, {rows, size.width, depth.row(rows.y_begin).data(),
                                 counts.row(rows.y_begin).data(), farthest.data()});
        ASSERT_EQ(counts, expected) << "case " << i;
    }
}

}  // namespace
}  // namespace scanlight::raster
