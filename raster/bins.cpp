#include "raster/bins.h"

#include <algorithm>

namespace scanlight::raster {

namespace {

std::vector<ScreenVertex<0>> corners_of(const PolygonStreams& streams, std::size_t face) {
    std::vector<ScreenVertex<0>> corners;
    for (const std::uint32_t v : streams.face(face))
        corners.push_back(streams.corner(v));
    return corners;
}

Rows rows_of(const std::vector<ScreenVertex<0>>& corners) {
    const auto [top, bottom] = std::minmax_element(
        corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    return {first_centre(top->y), first_centre(bottom->y)};
}

/// Culls those polygons one by one that the culler of triangles passed on.
class OneByOne {
public:
    OneByOne(const PolygonStreams& streams, CullRule rule, const ClipFace& clip_face,
             FateCounts& fates)
        : streams_(streams), rule_(rule), clip_face_(clip_face), fates_(fates) {}

    /// Fills in the polygon's rows and flags, or takes it out by giving it no rows.
    void settle(Survivors& survivors, std::size_t i) {
        const FaceItem face = static_cast<FaceItem>(survivors.item[i]) & face_mask;
        const Seen seen = part_inside(face);
        const bool back = (signed_area(seen.corners) >= 0) == streams_.mirrored;
        const Rows rows = is_drawn(seen, back) ? rows_of(seen.corners) : Rows{0, 0};
        survivors.set(i, face | (back ? back_flag : 0) | (is_walked(seen) ? walk_flag : 0), rows);
    }

private:
    /// What of a face is inside the view volume.
    struct Seen {
        std::vector<ScreenVertex<0>> corners;
        bool whole;
    };

    Seen part_inside(FaceItem face) const {
        std::int32_t of_one_plane = ~0;  // bits of planes beyond which all corners lie
        std::int32_t of_any = 0;
        for (const std::uint32_t v : streams_.face(face)) {
            of_one_plane &= streams_.outside[v];
            of_any |= streams_.outside[v];
        }
        if (of_any == 0) return {corners_of(streams_, face), true};
        if (of_one_plane != 0) return {{}, false};
        return {clip_face_(face), false};
    }

    bool is_drawn(const Seen& seen, bool back) {
        if (seen.corners.size() < 3) {
            ++fates_.outside;
            return false;
        }
        if (back ? rule_.back : rule_.front) {
            ++fates_.culled;
            return false;
        }
        ++fates_.drawn;
        return seen.corners.size() != 3 || signed_area(seen.corners) != 0;
    }

    static bool is_walked(const Seen& seen) { return seen.corners.size() != 3 || !seen.whole; }

    const PolygonStreams& streams_;
    CullRule rule_;
    const ClipFace& clip_face_;
    FateCounts& fates_;
};

/// Counting sort, which keeps the order.
void sort_into_bands(const Survivors& survivors, const Bands& bands, Bin& bin) {
    const auto for_each_band = [&](std::size_t i, auto&& use) {
        if (survivors.y_begin[i] >= survivors.y_end[i]) return;
        const int last = bands.holding(survivors.y_end[i] - 1);
        for (int b = bands.holding(survivors.y_begin[i]); b <= last; ++b)
            use(static_cast<std::size_t>(b));
    };
    const auto band_count = static_cast<std::size_t>(bands.count());
    bin.begin.assign(band_count + 1, 0);
    for (std::size_t i = 0; i < survivors.count; ++i)
        for_each_band(i, [&](std::size_t b) { ++bin.begin[b + 1]; });
    for (std::size_t b = 0; b < band_count; ++b)
        bin.begin[b + 1] += bin.begin[b];
    bin.items.resize(bin.begin.back());
    std::vector<std::size_t> next(bin.begin.begin(), bin.begin.end() - 1);
    for (std::size_t i = 0; i < survivors.count; ++i) {
        for_each_band(i, [&](std::size_t b) {
            bin.items[next[b]++] = static_cast<FaceItem>(survivors.item[i]);
        });
    }
}

}  // namespace

Bands bands_in_cache(Viewport size, int numbers) {
    constexpr std::int64_t cache = 5 << 18;  // most of the 2 MiB that there are; or all
    const std::int64_t bytes_a_row = std::int64_t{4} * numbers * size.width;
    Bands bands{size.height};
    while (bands.row_bits > 3 && bytes_a_row << bands.row_bits > cache)
        --bands.row_bits;
    return bands;
}

void fill_bin(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
              const Bands& bands, CullFaces cull, const ClipFace& clip_face, Survivors& scratch,
              Bin& bin) {
    bin.fates = {};
    scratch.reserve(end - begin + most_lanes);
    cull(streams, rule, begin, end, scratch, bin.fates);
    OneByOne one_by_one(streams, rule, clip_face, bin.fates);
    for (std::size_t i = 0; i < scratch.count; ++i) {
        if (scratch.is_passed_on(i)) one_by_one.settle(scratch, i);
    }
    sort_into_bands(scratch, bands, bin);
}

}  // namespace scanlight::raster
