#pragma once

#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

// How a row of colours becomes pixels, where something is shown. Each returns how many there were.

inline std::size_t store_floats(const VectorStreams& row, const raster::Item* items,
                                std::span<raster::Rgba> to) {
    std::size_t pixels = 0;
    for (std::size_t x = 0; x < to.size(); ++x) {
        if (items[x] < 0) continue;
        to[x] = raster::Rgba(row.x[x], row.y[x], row.z[x], 1.0f);
        ++pixels;
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

inline Ints load_some(const std::int32_t* from, int room) {
    if (room >= lane_count) return load(from);
    std::int32_t values[lane_count] = {};
    std::copy_n(from, room, values);
    return load(values);
}

template <raster::Encoding encoding>
SCANLIGHT_FLATTEN std::size_t store_packed(const VectorStreams& row, const raster::Item* items,
                                           std::span<raster::PackedPixel> to) {
    auto* const out = reinterpret_cast<std::int32_t*>(to.data());
    const int width = static_cast<int>(to.size());
    std::size_t pixels = 0;
    for (int x = 0; x < width; x += lane_count) {
        const Mask shown = Ints(-1) < load(items + x);
        if (!any(shown)) continue;
        const Ints packed = pack_lanes<encoding>(load(row.x.data() + x), load(row.y.data() + x),
                                                 load(row.z.data() + x));
        const int room = width - x;
        store_some(all(shown) ? packed : select(shown, packed, load_some(out + x, room)), room,
                   out + x);
        pixels += static_cast<std::size_t>(count(shown));
    }
    return pixels;
}

inline std::size_t store_row(const VectorStreams& row, raster::VisibleBand& band, int y,
                             const Target& target) {
    const raster::Item* items = band.item_row(y);
    if (const auto* floats = std::get_if<FloatTarget>(&target))
        return store_floats(row, items, floats->plane->row(y));
    const auto& packed = std::get<PackedTarget>(target);
    return packed.encoding == raster::Encoding::srgb
               ? store_packed<raster::Encoding::srgb>(row, items, packed.plane->row(y))
               : store_packed<raster::Encoding::linear>(row, items, packed.plane->row(y));
}

}  // namespace scanlight::render::HWY_NAMESPACE
