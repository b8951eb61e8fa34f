#include "raster/bins.h"

#include <algorithm>

#include "raster/project.h"

namespace scanlight::raster {

namespace {

std::vector<ScreenVertex<0>> corners_of(const PolygonStreams& streams, std::size_t face) {
    std::vector<ScreenVertex<0>> corners;
    for (const std::uint32_t v : streams.face(face))
        corners.push_back(streams.corner(v));
    return corners;
}

struct Outside {
    std::int32_t of_one_plane = ~0;  // bits of planes beyond which all corners lie
    std::int32_t of_any = 0;
};

Outside outside(const PolygonStreams& streams, std::size_t face) {
    Outside result;
    for (const std::uint32_t v : streams.face(face)) {
        result.of_one_plane &= streams.outside[v];
        result.of_any |= streams.outside[v];
    }
    return result;
}

/// Sorts the polygons that the culler of triangles passed on, and joins them to the others.
class Sorter {
public:
    Sorter(const PolygonStreams& streams, CullRule rule, const ClipFace& clip_face, Bin& bin)
        : streams_(streams), rule_(rule), clip_face_(clip_face), bin_(bin) {}

    /// Fills in the rows, or takes the polygon out by giving it none.
    void settle(Survivors& survivors, std::size_t i) {
        survivors.y_begin[i] = survivors.y_end[i] = 0;
        const auto face =
            static_cast<std::size_t>(static_cast<FaceItem>(survivors.item[i]) & face_mask);
        const Outside where = outside(streams_, face);
        const bool whole = where.of_any == 0;
        std::vector<ScreenVertex<0>> corners;
        if (whole) corners = corners_of(streams_, face);
        if (!whole && where.of_one_plane == 0) corners = clip_face_(face);
        if (corners.size() < 3) {
            ++bin_.fates.outside;
            return;
        }
        const std::int64_t area = signed_area(corners);
        const bool back = (area >= 0) == streams_.mirrored;
        if (back ? rule_.back : rule_.front) {
            ++bin_.fates.culled;
            return;
        }
        ++bin_.fates.drawn;
        const Rows rows = rows_of(corners);
        if (area == 0 && corners.size() == 3) return;
        survivors.y_begin[i] = rows.y_begin;
        survivors.y_end[i] = rows.y_end;
        FaceItem item = static_cast<FaceItem>(face) | (back ? back_flag : 0);
        if (corners.size() != 3 || !whole) item |= walk_flag;
        survivors.item[i] = static_cast<std::int32_t>(item);
    }

private:
    static Rows rows_of(const std::vector<ScreenVertex<0>>& corners) {
        const auto [top, bottom] = std::minmax_element(
            corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
        return {first_centre(top->y), first_centre(bottom->y)};
    }

    const PolygonStreams& streams_;
    CullRule rule_;
    const ClipFace& clip_face_;
    Bin& bin_;
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

void fill_bin(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
              const Bands& bands, CullFaces cull, const ClipFace& clip_face, Survivors& scratch,
              Bin& bin) {
    constexpr std::size_t most_lanes = 64;
    bin.fates = {};
    scratch.reserve(end - begin + most_lanes);
    cull(streams, rule, begin, end, scratch, bin.fates);
    Sorter sorter(streams, rule, clip_face, bin);
    for (std::size_t i = 0; i < scratch.count; ++i) {
        if ((static_cast<FaceItem>(scratch.item[i]) & walk_flag) != 0) sorter.settle(scratch, i);
    }
    sort_into_bands(scratch, bands, bin);
}

}  // namespace scanlight::raster
