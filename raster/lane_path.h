#pragma once

#include <span>
#include <string_view>

#include "raster/bins.h"
#include "raster/polygon_streams.h"
#include "raster/ramp.h"
#include "raster/visible_band.h"

namespace scanlight::raster {

/// Takes the spans of a walked polygon.
struct SpanPainter {
    virtual ~SpanPainter();
    /// Pixels [x_begin, x_end) of row y. Ramps begin at x_begin; as many of attributes as the
    /// painter interpolates.
    virtual void draw_span(int y, int x_begin, int x_end, const Ramp& depth,
                           const Ramp* attributes) = 0;
};

/// Draws a polygon that is no whole triangle with a plane: by the walk down its edges.
struct Walker {
    virtual ~Walker();
    virtual void draw(FaceItem face, SpanPainter& spans) = 0;
};

/// The vector code of this room for one instruction set. All sets give the same bits.
struct LanePath {
    std::string_view name;  // "AVX3", "AVX2", "SSE4", …
    int lanes;              // floats in a vector

    CullFaces cull_faces;

    /// Draws polygons into a band, in their order: depth, and as the only number kept the item plus
    /// `first`.
    void (*draw_items)(const PolygonStreams&, std::span<const FaceItem> items, std::int32_t first,
                       VisibleBand&, Walker&);
};

/// Those that this machine can run, the fastest first; never empty.
std::span<const LanePath* const> lane_paths();

}  // namespace scanlight::raster
