#pragma once

#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

// How a row of colours becomes pixels, where something is shown. Each returns how many there were.

inline std::size_t store_floats(const VectorStreams& row, const raster::Item* items,
                                const FloatTarget& target, int y, Background background) {
    const auto to = target.plane->row(y);
    std::size_t pixels = 0;
    for (std::size_t x = 0; x < to.size(); ++x) {
        const bool shown = items[x] >= 0;
        if (shown) to[x] = raster::Rgba(row.x[x], row.y[x], row.z[x], 1.0f);
        if (!shown && background == Background::drawn) to[x] = target.background;
        pixels += shown ? 1 : 0;
    }
    return pixels;
}

/// Whole vectors would write beyond the row's end, where another thread's may begin.
inline void store_some(Ints pixels, int room, std::int32_t* to) {
    if (room >= lane_count) return store(pixels, to);
    std::int32_t values[lane_count];
    store(pixels, values);
    std::copy_n(values, room, to);
}

/// The pixels that are there already.
inline Ints kept(const std::int32_t* from, int room) {
    if (room >= lane_count) return load(from);
    std::int32_t values[lane_count] = {};
    std::copy_n(from, room, values);
    return load(values);
}

/// Columns [begin, end), all of which may be seen.
template <raster::Encoding encoding>
SCANLIGHT_FLATTEN std::size_t store_columns(const VectorStreams& row, const raster::Item* items,
                                            raster::Columns columns, const PackedTarget& target,
                                            std::int32_t* out, Background background) {
    const Ints nothing(static_cast<std::int32_t>(target.background));
    std::size_t pixels = 0;
    for (int x = columns.begin; x < columns.end; x += lane_count) {
        const int room = columns.end - x;
        const Mask shown = first_lanes(std::min(room, lane_count)) & (Ints(-1) < load(items + x));
        const Ints packed = pack_lanes<encoding>(load(row.x.data() + x), load(row.y.data() + x),
                                                 load(row.z.data() + x));
        const Ints other = background == Background::drawn ? nothing : kept(out + x, room);
        store_some(select(shown, packed, other), room, out + x);
        pixels += static_cast<std::size_t>(count(shown));
    }
    return pixels;
}

template <raster::Encoding encoding>
std::size_t store_packed(const VectorStreams& row, raster::VisibleBand& band, int y,
                         const PackedTarget& target, Background background) {
    const auto to = target.plane->row(y);
    const raster::Columns columns = band.touched();
    if (background == Background::drawn) {
        std::fill_n(to.begin(), columns.begin, target.background);
        std::fill(to.begin() + columns.end, to.end(), target.background);
    }
    return store_columns<encoding>(row, band.item_row(y), columns, target,
                                   reinterpret_cast<std::int32_t*>(to.data()), background);
}

inline std::size_t store_row(const VectorStreams& row, raster::VisibleBand& band, int y,
                             const Target& target, Background background) {
    const raster::Item* items = band.item_row(y);
    if (const auto* floats = std::get_if<FloatTarget>(&target))
        return store_floats(row, items, *floats, y, background);
    const auto& packed = *std::get_if<PackedTarget>(&target);  // std::get could throw
    return packed.encoding == raster::Encoding::srgb
               ? store_packed<raster::Encoding::srgb>(row, band, y, packed, background)
               : store_packed<raster::Encoding::linear>(row, band, y, packed, background);
}

}  // namespace scanlight::render::HWY_NAMESPACE
