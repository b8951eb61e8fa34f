#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "raster/bins.h"
#include "raster/fill.h"
#include "raster/polygon_streams.h"
#include "raster/visible_band.h"

namespace scanlight::raster {

/// One thread's scratch memory for drawing bands.
struct BandScratch {
    PolygonFiller<0> filler;
    std::vector<ScreenVertex<0>> corners;
};

/// The vector code of this room for one instruction set. All sets give the same bits.
struct LanePath {
    std::string_view name;  // "AVX3", "AVX2", "SSE4", …
    int lanes;              // floats in a vector

    CullFaces cull_faces;

    /// Draws polygons into a band, depth and items only, numbered from `first` on. A triangle found
    /// too thin for a plane gets `walk_flag`.
    void (*draw_items)(const PolygonStreams&, const Bin&, std::span<FaceItem> items, Item first,
                       VisibleBand&, BandScratch&, PixelCounts&);
};

/// Those that this machine can run, the fastest first; never empty.
std::span<const LanePath* const> lane_paths();

}  // namespace scanlight::raster
