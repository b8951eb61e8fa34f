#pragma once

#include <cstddef>
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

/// The attributes of a polygon of up to four corners as they are interpolated, if all of it lies
/// inside the view volume; of others they are of no use.
class CornerAttributes {
public:
    static constexpr int most_corners = 4;

    /// The first corner's first one; from an attribute to the next, and from a corner to the next.
    CornerAttributes(const Attribute* first, std::ptrdiff_t next, std::ptrdiff_t next_corner)
        : first_(first), next_(next), next_corner_(next_corner) {}

    Attribute at(std::size_t corner, std::size_t attribute) const {
        return first_[static_cast<std::ptrdiff_t>(corner) * next_corner_ +
                      static_cast<std::ptrdiff_t>(attribute) * next_];
    }

private:
    const Attribute* first_;
    std::ptrdiff_t next_, next_corner_;
};

/// Draws a polygon that is no whole triangle with a plane: by the walk down its edges.
struct Walker {
    virtual ~Walker();
    /// `known` may be null.
    virtual void draw(FaceItem face, const CornerAttributes* known, SpanPainter& spans) = 0;
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
