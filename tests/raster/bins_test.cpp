#include "raster/bins.h"

#include <gtest/gtest.h>

#include "raster/lane_path.h"
#include "tests/raster/random_streams.h"

namespace scanlight::raster {
namespace {

using laws::FaceFate;
using laws::Random;

TEST(Bands, HoldEachRowOnce) {
    for (const int height : {1, 31, 32, 33, 217, max_size}) {
        for (const int row_bits : {0, 3, 5}) {
            const Bands bands{height, row_bits};
            int row = 0;
            for (int b = 0; b < bands.count(); ++b) {
                EXPECT_EQ(bands[b].y_begin, row);
                ASSERT_LT(bands[b].y_begin, bands[b].y_end);
                for (; row < bands[b].y_end; ++row)
                    ASSERT_EQ(bands.holding(row), b);
            }
            EXPECT_EQ(row, height);
        }
    }
}

TEST(Bands, StayInACoresCache) {
    EXPECT_EQ(bands_in_cache({1920, 1080}, 2).row_bits, 5);
    EXPECT_EQ(bands_in_cache({1920, 1080}, 5).row_bits, 5);
    EXPECT_EQ(bands_in_cache({1920, 1080}, 8).row_bits, 4);
    EXPECT_EQ(bands_in_cache({max_size, max_size}, 12).row_bits, 3);
}

Bin filled_bin(const laws::RandomStreams& polygons, CullRule rule, const Bands& bands,
               const LanePath& path, std::size_t begin, std::size_t end) {
    Survivors scratch;
    Bin bin;
    fill_bin(
        polygons.streams(), rule, begin, end, bands, path.cull_faces,
        [&](std::size_t face) { return polygons.clipped(face); }, scratch, bin);
    return bin;
}

bool touches(const FaceFate& fate, Rows band) {
    return fate.kind == FaceFate::drawn &&
           std::max(fate.rows.y_begin, band.y_begin) < std::min(fate.rows.y_end, band.y_end);
}

/// Who has no pixel's centre in his box may be left out.
void expect_band(const laws::RandomStreams& polygons, CullRule rule, Rows rows,
                 std::span<const FaceItem> items, std::size_t begin, std::size_t end) {
    std::size_t i = 0;
    for (std::size_t face = begin; face < end; ++face) {
        const FaceFate fate = fate_of(polygons, face, rule);
        const bool found = i < items.size() && (items[i] & face_mask) == face;
        ASSERT_TRUE(found ? touches(fate, rows) : !touches(fate, rows) || !fate.may_cover)
            << "face " << face;
        if (!found) continue;
        EXPECT_EQ((items[i] & back_flag) != 0, fate.back) << "face " << face;
        EXPECT_EQ((items[i] & walk_flag) != 0, fate.walked) << "face " << face;
        ++i;
    }
    EXPECT_EQ(i, items.size()) << "out of order, or from nowhere";
}

void expect_counts(const laws::RandomStreams& polygons, CullRule rule, const FateCounts& counted,
                   std::size_t begin, std::size_t end) {
    FateCounts counts;
    for (std::size_t face = begin; face < end; ++face)
        count_fate(counts, fate_of(polygons, face, rule));
    EXPECT_EQ(counts.outside, counted.outside);
    EXPECT_EQ(counts.culled, counted.culled);
    EXPECT_EQ(counts.drawn, counted.drawn);
}

TEST(Bin, HoldsEachPolygonInTheBandsItTouchesInOrder) {
    Random random(1);
    for (int i = 0; i < laws::cases(500); ++i) {
        const int height = random.between(1, 100);
        const laws::RandomStreams polygons(random, random.between(0, 150), height * subpixels);
        const CullRule rule = laws::random_rule(random);
        const Bands bands{height, random.between(0, 6)};
        const auto count = static_cast<int>(polygons.face_count());
        const auto begin = static_cast<std::size_t>(random.between(0, count));
        const auto end = static_cast<std::size_t>(random.between(static_cast<int>(begin), count));
        for (const LanePath* path : lane_paths()) {
            SCOPED_TRACE(path->name);
            const Bin bin = filled_bin(polygons, rule, bands, *path, begin, end);
            for (int b = 0; b < bands.count(); ++b)
                expect_band(polygons, rule, bands[b], bin.band(b), begin, end);
            expect_counts(polygons, rule, bin.fates, begin, end);
        }
        ASSERT_FALSE(HasFailure()) << "case " << i;
    }
}

TEST(Bin, ForgetsWhatItHeldBefore) {
    Random random(2);
    const laws::RandomStreams polygons(random, 90, 64 * subpixels);
    const LanePath& path = *lane_paths().front();
    const auto clip = [&](std::size_t face) { return polygons.clipped(face); };
    Survivors scratch;
    Bin bin;
    for (const int height : {64, 200, 64}) {
        fill_bin(polygons.streams(), {}, 0, 90, {height, 16}, path.cull_faces, clip, scratch, bin);
        const Bin fresh = filled_bin(polygons, {}, {height, 16}, path, 0, 90);
        EXPECT_EQ(bin.items, fresh.items);
        EXPECT_EQ(bin.begin, fresh.begin);
        EXPECT_EQ(bin.fates.drawn, fresh.fates.drawn);
    }
    fill_bin(polygons.streams(), {}, 90, 90, {64, 16}, path.cull_faces, clip, scratch, bin);
    EXPECT_TRUE(bin.items.empty());
    EXPECT_EQ(bin.fates.drawn, 0u);
}

}  // namespace
}  // namespace scanlight::raster
