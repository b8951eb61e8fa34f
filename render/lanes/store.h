#pragma once

#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

// How a row of colours becomes pixels, where something is shown. Each returns how many there were.

inline std::size_t store_floats(const VectorStreams& row, FaceRange faces,
                                const std::int32_t* items, const FloatTarget& target, int y,
                                Background background) {
    const auto to = target.row(y);
    std::size_t pixels = 0;
    for (std::size_t x = 0; x < to.size(); ++x) {
        const bool shown = faces.holds(items[x]);
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

/// `FaceRange::holds`.
inline Mask lanes_held(FaceRange faces, Ints item) {
    const Ints face =
        (item & Ints(static_cast<std::int32_t>(raster::face_mask))) - Ints(faces.first);
    return (Ints(-1) < face) & (face < Ints(faces.count));
}

/// Columns [begin, end), all of which may be seen.
template <raster::Encoding encoding>
SCANLIGHT_FLATTEN std::size_t store_columns(const VectorStreams& row, FaceRange faces,
                                            const std::int32_t* items, raster::Columns columns,
                                            const PackedTarget& target, std::int32_t* out,
                                            Background background) {
    const Ints nothing(static_cast<std::int32_t>(target.background));
    std::size_t pixels = 0;
    for (int x = columns.begin; x < columns.end; x += lane_count) {
        const int room = columns.end - x;
        const Mask shown =
            first_lanes(std::min(room, lane_count)) & lanes_held(faces, load(items + x));
        const Ints packed = pack_lanes<encoding>(load(row.x.data() + x), load(row.y.data() + x),
                                                 load(row.z.data() + x));
        const Ints other = background == Background::drawn ? nothing : kept(out + x, room);
        store_some(select(shown, packed, other), room, out + x);
        pixels += static_cast<std::size_t>(count(shown));
    }
    return pixels;
}

/// Columns in which nothing is seen.
inline void store_background(raster::Columns seen, const PackedTarget& target, int y) {
    const auto to = target.row(y);
    std::fill_n(to.begin(), seen.begin, target.background);
    std::fill(to.begin() + seen.end, to.end(), target.background);
}

template <raster::Encoding encoding>
std::size_t store_packed(const VectorStreams& row, FaceRange faces, raster::VisibleBand& band,
                         int y, const PackedTarget& target, Background background) {
    const raster::Columns columns = band.touched();
    if (background == Background::drawn) store_background(columns, target, y);
    return store_columns<encoding>(row, faces, band.kept_row(0, y), columns, target,
                                   reinterpret_cast<std::int32_t*>(target.row(y).data()),
                                   background);
}

/// Pixels that are kept ready.
SCANLIGHT_FLATTEN inline void store_pixels(raster::VisibleBand& band, int y,
                                           const PackedTarget& target) {
    const raster::Columns columns = band.touched();
    if (columns.begin >= columns.end) return store_background({0, 0}, target, y);
    store_background(columns, target, y);
    auto* out = reinterpret_cast<std::int32_t*>(target.row(y).data());
    const Ints nothing(static_cast<std::int32_t>(target.background));
    for (int x = columns.begin; x < columns.end; x += lane_count) {
        const raster::PixelPlace at = band.row(y) + x;
        const Mask shown = load(at.depth) < Ints(raster::depth_clear);
        store_some(select(shown, load(at.kept(0)), nothing), columns.end - x, out + x);
    }
}

inline std::size_t store_row(const VectorStreams& row, FaceRange faces, raster::VisibleBand& band,
                             int y, const Target& target, Background background) {
    const std::int32_t* items = band.kept_row(0, y);
    if (const auto* floats = std::get_if<FloatTarget>(&target))
        return store_floats(row, faces, items, *floats, y, background);
    const auto& packed = *std::get_if<PackedTarget>(&target);  // std::get could throw
    return packed.encoding == raster::Encoding::srgb
               ? store_packed<raster::Encoding::srgb>(row, faces, band, y, packed, background)
               : store_packed<raster::Encoding::linear>(row, faces, band, y, packed, background);
}

}  // namespace scanlight::render::HWY_NAMESPACE
