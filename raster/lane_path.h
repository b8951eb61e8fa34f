#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include "raster/attribute_records.h"
#include "raster/bins.h"
#include "raster/polygon_streams.h"
#include "raster/ramp.h"
#include "raster/visible_band.h"

namespace scanlight::raster {

/// Draws a polygon that is no whole triangle with a plane: by the walk down its edges.
struct Walker {
    virtual ~Walker() = default;
    virtual void draw(FaceItem face) = 0;
};

/// The vector code of this room for one instruction set. All sets give the same bits.
struct LanePath {
    std::string_view name;  // "AVX3", "AVX2", "SSE4", …
    int lanes;              // floats in a vector

    CullFaces cull_faces;

    /// Draws polygons into a band: depth, and records of those that come to be seen. Only the faces
    /// of the records are written, not their attributes.
    void (*draw_items)(const PolygonStreams&, std::span<const FaceItem> items, VisibleBand&,
                       AttributeRecords&, Walker&);

    /// Draws pixels [x_begin, x_end) of a row, their depth by a ramp that begins at x_begin; how
    /// many came to be seen.
    std::size_t (*draw_span)(Depth* depth, Item* items, int x_begin, int x_end, const Ramp& ramp,
                             Item item);
};

/// Those that this machine can run, the fastest first; never empty.
std::span<const LanePath* const> lane_paths();

}  // namespace scanlight::raster
