#pragma once

#include <tuple>
#include <vector>

#include "raster/fill.h"
#include "raster/lane_path.h"
#include "render/object_pass.h"

namespace scanlight::render {

/// A vertex in clip space, by the same steps as those of the vertex stage.
glm::vec4 clip_position(const ObjectPass& pass, std::uint32_t vertex);

/// The part of a face inside the view volume, on the screen, without attributes.
std::vector<raster::ScreenVertex<0>> clipped_face(const ObjectPass& pass, std::size_t face);

/// Memory that a walker keeps from one polygon to the next.
template <int N>
struct WalkMemory {
    raster::PolygonFiller<N> filler;
    std::vector<raster::ScreenVertex<N>> corners;
};
using WalkMemories = std::tuple<WalkMemory<0>, WalkMemory<3>, WalkMemory<4>, WalkMemory<6>,
                                WalkMemory<7>, WalkMemory<9>>;

/// The textbook's way within the fast path: n-gons, clipped polygons and slivers go down their
/// edges, span by span.
class Walker : public raster::Walker {
public:
    /// Draws the spans in `rows`.
    Walker(const ObjectPass& pass, WalkMemories& memories, raster::Rows rows)
        : pass_(pass), memories_(memories), rows_(rows) {}

    void draw(raster::FaceItem face, const raster::CornerAttributes* known,
              raster::SpanPainter& spans) override;

private:
    template <int N>
    void walk(raster::FaceItem face, const raster::CornerAttributes* known,
              raster::SpanPainter& spans);

    const ObjectPass& pass_;
    WalkMemories& memories_;
    raster::Rows rows_;
};

}  // namespace scanlight::render
