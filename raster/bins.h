#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "raster/polygon_streams.h"
#include "raster/project.h"
#include "raster/rows.h"
#include "raster/streams.h"

namespace scanlight::raster {

/// The bands into which a picture's rows are cut: each is drawn by one thread.
struct Bands {
    int height = 0;    // of the picture
    int row_bits = 5;  // a band has two to this power of rows

    int count() const { return holding(height - 1) + 1; }
    Rows operator[](int band) const {
        const int end = (band + 1) << row_bits;
        return {band << row_bits, end < height ? end : height};
    }
    int holding(int row) const { return row >> row_bits; }
};

/// Bands of 32 rows, or of as many as stay in a core's own cache where each pixel keeps so many
/// 32-bit numbers; but 8 or more.
Bands bands_in_cache(Viewport size, int numbers);

/// The polygons of one stretch of faces, sorted into bands: a polygon lies in each band it touches,
/// and in each band they keep their order.
struct Bin {
    std::vector<FaceItem> items;
    std::vector<std::size_t> begin;  // bands + 1 of them, into `items`
    FateCounts fates;

    std::size_t bytes() const { return bytes_held(items, begin); }
    std::span<const FaceItem> band(int i) const {
        const auto k = static_cast<std::size_t>(i);
        return std::span(items).subspan(begin[k], begin[k + 1] - begin[k]);
    }
};

/// The part of a face inside the view volume, on the screen; empty when all is outside.
using ClipFace = std::function<std::vector<ScreenVertex<0>>(std::size_t face)>;

/// Culls faces [begin, end) and sorts what is left into bands. `cull` is one of `LanePath`.
/// Keeps the memory of `bin`.
using CullFaces = void (*)(const PolygonStreams&, CullRule, std::size_t begin, std::size_t end,
                           Survivors&, FateCounts&);
void fill_bin(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
              const Bands& bands, CullFaces cull, const ClipFace& clip_face, Survivors& scratch,
              Bin& bin);

}  // namespace scanlight::raster
