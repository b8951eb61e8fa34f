#pragma once

#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

// How a row of colours becomes pixels, where something is shown. Each returns how many there were.

template <class Store>
std::size_t for_each_shown(const raster::Item* items, int width, Store&& store_at) {
    std::size_t pixels = 0;
    for (int x = 0; x < width; x += lane_count) {
        const Mask shown = Ints(-1) < load(items + x);
        if (!any(shown)) continue;
        store_at(x, shown);
        pixels += static_cast<std::size_t>(count(shown));
    }
    return pixels;
}

inline std::size_t store_floats(const VectorStreams& row, const raster::Item* items,
                                std::span<raster::Rgba> to) {
    return for_each_shown(items, static_cast<int>(to.size()), [&](int x, Mask shown) {
        for (std::uint32_t left = bits_of(shown); left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(x + std::countr_zero(left));
            to[i] = raster::Rgba(row.x[i], row.y[i], row.z[i], 1.0f);
        }
    });
}

/// Whole vectors would write beyond the row's end, where another thread's may begin.
inline void store_some(Mask where, Ints pixels, int room, std::int32_t* to) {
    if (room >= lane_count) return store_where(where, pixels, to);
    std::int32_t values[lane_count];
    store(pixels, values);
    for (std::uint32_t left = bits_of(where); left != 0; left &= left - 1)
        to[std::countr_zero(left)] = values[std::countr_zero(left)];
}

template <raster::Encoding encoding>
SCANLIGHT_FLATTEN std::size_t store_packed(const VectorStreams& row, const raster::Item* items,
                                           std::span<raster::PackedPixel> to) {
    auto* const pixels = reinterpret_cast<std::int32_t*>(to.data());
    const int width = static_cast<int>(to.size());
    return for_each_shown(items, width, [&](int x, Mask shown) {
        const Ints packed = pack_lanes<encoding>(load(row.x.data() + x), load(row.y.data() + x),
                                                 load(row.z.data() + x));
        store_some(shown, packed, width - x, pixels + x);
    });
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
