#pragma once

#include <tuple>
#include <vector>

#include "raster/clip.h"
#include "raster/visible_items.h"
#include "render/object_pass.h"

namespace scanlight::render {

/// A vertex in clip space, by the same steps as those of the vertex stage.
glm::vec4 clip_position(const ObjectPass& pass, std::uint32_t vertex);

/// The part of a face inside the view volume, on the screen, without attributes.
std::vector<raster::ScreenVertex<0>> clipped_face(const ObjectPass& pass, std::size_t face);

/// Polygons that are walked down their edges: n-gons, clipped ones, and slivers.
class WalkedPolygons {
public:
    /// Makes the records of all that `visible` has put apart, span by span.
    void record(const ObjectPass& pass, raster::VisibleBand& band, raster::VisibleItems& visible);

private:
    template <int N>
    void record_all(const ObjectPass& pass, raster::VisibleBand& band,
                    raster::VisibleItems& visible);

    std::tuple<raster::PolygonFiller<3>, raster::PolygonFiller<4>, raster::PolygonFiller<7>>
        fillers_;
};

}  // namespace scanlight::render
