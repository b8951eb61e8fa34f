#include "raster/lane_path.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string_view>

#include "raster/fill.h"
#include "raster/fragments.h"
#include "tests/raster/random_streams.h"

namespace scanlight::raster {
namespace {

using laws::FaceFate;
using laws::Random;

TEST(LanePaths, AreOfDifferentNamesAndTheWidestComesFirst) {
    ASSERT_FALSE(lane_paths().empty());
    std::set<std::string_view> names;
    int lanes = lane_paths().front()->lanes;
    for (const LanePath* path : lane_paths()) {
        EXPECT_TRUE(names.insert(path->name).second) << path->name;
        EXPECT_LE(path->lanes, lanes);
        EXPECT_GE(path->lanes, 4);
        lanes = path->lanes;
    }
}

// ---- spans

/// One row as `VisibleBand` holds it.
struct Row {
    std::vector<Depth> depth;
    std::vector<std::int32_t> items;

    bool operator==(const Row&) const = default;
    int width() const { return static_cast<int>(depth.size()) - VisibleBand::overrun; }
};

std::int32_t any_int(Random& random) {
    const int high = random.between(-32768, 32767);
    return high * 65536 + random.between(0, 65535);
}
std::int64_t any_long(Random& random) {
    const std::int64_t high = any_int(random);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(high) << 32) +
           static_cast<std::uint32_t>(any_int(random));
}

Row random_row(Random& random, int width) {
    Row row;
    for (int i = 0; i < width + VisibleBand::overrun; ++i) {
        row.depth.push_back(any_int(random));
        row.items.push_back(random.between(0, 1000));
    }
    return row;
}

constexpr std::int32_t drawn = 1001;  // a face whose number no row has

/// By the scanline walk, which has no use for the overrun.
std::size_t walk_span(Row& row, int x_begin, int x_end, const Ramp& ramp) {
    const int width = row.width();
    Plane<Depth> depth({width, 1}, 0);
    Plane<std::int32_t> items({width, 1}, 0);
    std::copy_n(row.depth.begin(), width, depth.row(0).begin());
    std::copy_n(row.items.begin(), width, items.row(0).begin());
    const auto shade = [](const Fragment<0>&) { return drawn; };
    const std::size_t passed =
        draw_span(Span<0>{0, x_begin, x_end, {ramp, {}}}, depth, items, shade);
    std::ranges::copy(depth.row(0), row.depth.begin());
    std::ranges::copy(items.row(0), row.items.begin());
    return passed;
}

/// Any polygon's only span.
struct OneSpan : Walker {
    int x_begin, x_end;
    Ramp depth;

    OneSpan(int begin, int end, const Ramp& ramp) : x_begin(begin), x_end(end), depth(ramp) {}
    void draw(FaceItem, const CornerAttributes*, SpanPainter& spans) override {
        spans.draw_span(0, x_begin, x_end, depth, nullptr);
    }
};

std::size_t fast_span(const LanePath& path, Row& row, int x_begin, int x_end, const Ramp& ramp) {
    const std::vector<std::int32_t> zeros(3);
    const std::vector<std::uint32_t> corners{0, 1, 2};
    const std::vector<std::uint32_t> begins(static_cast<std::size_t>(drawn) + 2);
    const PolygonStreams streams{zeros, zeros, zeros, zeros, corners, begins};
    VisibleBand band;
    band.clear(row.width(), {0, 1}, 1);
    std::ranges::copy(row.depth, band.depth_row(0));
    std::ranges::copy(row.items, band.kept_row(0, 0));
    OneSpan walker(x_begin, x_end, ramp);
    const FaceItem item = drawn | walk_flag;
    path.draw_items(streams, {&item, 1}, 0, band, walker);
    std::copy_n(band.depth_row(0), row.depth.size(), row.depth.begin());
    std::copy_n(band.kept_row(0, 0), row.items.size(), row.items.begin());
    for (std::int32_t& number : row.items)
        number = number == static_cast<std::int32_t>(item) ? drawn : number;
    EXPECT_EQ(band.counts().tested, static_cast<std::size_t>(x_end - x_begin));
    return band.counts().passed;
}

TEST(LanePathSpan, IsThatOfTheWalkForEveryStartAndLength) {
    Random random(1);
    for (int x_begin = 0; x_begin <= 70; ++x_begin) {
        for (int length = 0; length <= 70; ++length) {
            // No sum of the walk leaves 64 bits, but most of them 48: their depths wrap round.
            const Ramp ramp{any_long(random) / 2, any_long(random) / 512};
            const Row before = random_row(random, 140);
            Row walked = before;
            const std::size_t passed = walk_span(walked, x_begin, x_begin + length, ramp);
            for (const LanePath* path : lane_paths()) {
                Row row = before;
                ASSERT_EQ(fast_span(*path, row, x_begin, x_begin + length, ramp), passed)
                    << path->name << " from " << x_begin << ", " << length << " long";
                ASSERT_EQ(row, walked)
                    << path->name << " from " << x_begin << ", " << length << " long";
            }
        }
    }
}

/// `Ramp::get` after `x` steps, in numbers that wrap round.
std::int32_t wrapped(const Ramp& ramp, int x) {
    const std::uint64_t value =
        static_cast<std::uint64_t>(ramp.value) +
        static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(ramp.step_size) + Ramp::half;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value >> ramp_bits));
}

TEST(LanePathSpan, CountsModulo64Bits) {
    Random random(2);
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const Ramp ramp{any_long(random), any_long(random)};
        const int x_end = random.between(1, 70);
        for (const LanePath* path : lane_paths()) {
            Row row{
                std::vector<Depth>(70 + VisibleBand::overrun, std::numeric_limits<Depth>::max()),
                std::vector<std::int32_t>(70 + VisibleBand::overrun, no_item)};
            fast_span(*path, row, 0, x_end, ramp);
            for (int x = 0; x < x_end; ++x) {
                ASSERT_EQ(row.depth[static_cast<std::size_t>(x)], wrapped(ramp, x))
                    << path->name << ", pixel " << x;
            }
        }
    }
}

TEST(LanePathSpan, LosesNoCarryOverTheLongestRow) {
    Random random(3);
    for (const std::int64_t fraction : {0xffff, 0xfffe, 0x8000, 0x7fff, 1}) {
        const std::int64_t first = fraction == 1 ? 0x7fff : 0xffff;
        const Ramp ramp{std::int64_t{random.between(0, 1 << 28)} * 65536 + first,
                        std::int64_t{random.between(-30000, 30000)} * 65536 + fraction};
        const Row before = random_row(random, max_size);
        Row walked = before;
        const std::size_t passed = walk_span(walked, 0, max_size, ramp);
        for (const LanePath* path : lane_paths()) {
            Row row = before;
            EXPECT_EQ(fast_span(*path, row, 0, max_size, ramp), passed) << path->name;
            EXPECT_EQ(row, walked) << path->name;
        }
    }
}

// ---- polygons

/// By the textbook's filler.
struct FillWalker : Walker {
    const PolygonStreams& streams;
    Rows rows;
    PolygonFiller<0> filler;

    FillWalker(const PolygonStreams& polygons, Rows band) : streams(polygons), rows(band) {}
    template <class Emit>
    void fill(FaceItem item, Emit&& emit) {
        std::vector<ScreenVertex<0>> corners;
        for (const std::uint32_t v : streams.face(item & face_mask))
            corners.push_back(streams.corner(v));
        filler.fill(corners, Interpolation::planar, emit, NoObserver{}, rows);
    }
    void draw(FaceItem item, const CornerAttributes*, SpanPainter& spans) override {
        fill(item, [&](const Span<0>& span) {
            spans.draw_span(span.y, span.x_begin, span.x_end, span.ramps.depth, nullptr);
        });
    }
};

/// Those that lie wholly inside; each third is walked, though it need not be.
std::vector<FaceItem> items_inside(const laws::RandomStreams& polygons) {
    std::vector<FaceItem> items;
    for (std::size_t face = 0; face < polygons.face_count(); ++face) {
        const auto corners = polygons.streams().face(face);
        const bool inside = std::ranges::all_of(
            corners, [&](std::uint32_t v) { return polygons.streams().outside[v] == 0; });
        const bool walked = corners.size() != 3 || face % 3 == 0;
        if (inside) items.push_back(static_cast<FaceItem>(face) | (walked ? walk_flag : 0));
    }
    return items;
}

TEST(LanePathItems, CoverAndHideAsTheWalkDoes) {
    Random random(5);
    for (int i = 0; i < laws::cases(600); ++i) {
        const int width = random.one_in(2) ? random.between(1, 40) : random.between(1, 300);
        const laws::RandomStreams polygons(random, random.between(1, 60), width * subpixels);
        const PolygonStreams streams = polygons.streams();
        const std::vector<FaceItem> items = items_inside(polygons);
        const int first = random.between(0, width - 1);
        const Rows rows{first, random.between(first + 1, width)};
        Plane<Depth> depth({width, width}, depth_clear);
        Plane<std::int32_t> seen({width, width}, no_item);
        FillWalker walk(streams, rows);
        for (const FaceItem item : items) {
            walk.fill(item, [&](const Span<0>& span) {
                draw_span(span, depth, seen,
                          [&](const Fragment<0>&) { return static_cast<std::int32_t>(item); });
            });
        }
        for (const LanePath* path : lane_paths()) {
            VisibleBand band;
            band.clear(width, rows, 1);
            FillWalker walker(streams, rows);
            path->draw_items(streams, items, 0, band, walker);
            for (int y = rows.y_begin; y < rows.y_end; ++y) {
                for (int x = 0; x < width; ++x) {
                    ASSERT_EQ(band.depth_row(y)[x], depth.at(x, y)) << path->name << ", case " << i;
                    ASSERT_EQ(band.kept_row(0, y)[x], seen.at(x, y))
                        << path->name << ", case " << i;
                }
            }
        }
    }
}

// ---- culling

struct Culled {
    Survivors survivors;
    FateCounts counts;
};

Culled cull(const LanePath& path, const PolygonStreams& streams, CullRule rule, std::size_t begin,
            std::size_t end) {
    Culled result;
    result.survivors.reserve(end - begin + 64);
    path.cull_faces(streams, rule, begin, end, result.survivors, result.counts);
    return result;
}

void expect_item(const FaceFate& fate, FaceItem item, const Survivors& survivors, std::size_t i) {
    EXPECT_EQ(fate.kind, FaceFate::drawn);
    EXPECT_TRUE(fate.may_cover);
    EXPECT_EQ((item & walk_flag) != 0, fate.walked);
    EXPECT_EQ((item & back_flag) != 0, fate.back);
    EXPECT_EQ(survivors.y_begin[i], fate.rows.y_begin);
    EXPECT_EQ(survivors.y_end[i], fate.rows.y_end);
}

/// Faces come in their order; what is left out could cover nothing; what is passed on waits.
void expect_fates(const laws::RandomStreams& polygons, CullRule rule, std::size_t begin,
                  std::size_t end, const Culled& culled) {
    FateCounts counts;
    std::size_t i = 0;
    const auto item_of = [&](std::size_t k) {
        return static_cast<FaceItem>(culled.survivors.item[k]);
    };
    for (std::size_t face = begin; face < end; ++face) {
        const FaceFate fate = fate_of(polygons, face, rule);
        const bool found = i < culled.survivors.count && (item_of(i) & face_mask) == face;
        if (found && culled.survivors.is_passed_on(i)) {
            ++i;
            continue;
        }
        EXPECT_FALSE(fate.clipped) << "face " << face;
        count_fate(counts, fate);
        const bool goes_on = fate.kind == FaceFate::drawn && fate.may_cover;
        ASSERT_EQ(found, goes_on) << "face " << face;
        if (found) expect_item(fate, item_of(i), culled.survivors, i);
        if (found) ++i;
    }
    EXPECT_EQ(i, culled.survivors.count);
    EXPECT_EQ(counts.outside, culled.counts.outside);
    EXPECT_EQ(counts.culled, culled.counts.culled);
    EXPECT_EQ(counts.drawn, culled.counts.drawn);
}

TEST(LanePathCull, GivesEachTriangleTheFateItHasAlone) {
    Random random(4);
    for (int i = 0; i < laws::cases(1500); ++i) {
        const laws::RandomStreams polygons(random, random.between(0, 120), 64 * subpixels);
        const CullRule rule = laws::random_rule(random);
        const auto count = static_cast<int>(polygons.face_count());
        const auto begin = static_cast<std::size_t>(random.between(0, count));
        const auto end = static_cast<std::size_t>(random.between(static_cast<int>(begin), count));
        for (const LanePath* path : lane_paths()) {
            SCOPED_TRACE(path->name);
            expect_fates(polygons, rule, begin, end,
                         cull(*path, polygons.streams(), rule, begin, end));
        }
        ASSERT_FALSE(HasFailure()) << "case " << i;
    }
}

}  // namespace
}  // namespace scanlight::raster
