#include "render/walked.h"

#include <cassert>

#include "raster/project.h"
#include "render/transform.h"

namespace scanlight::render {

namespace {

template <int N>
std::vector<raster::ClipVertex<N>> gathered(const ObjectPass& pass, raster::FaceItem item) {
    std::vector<raster::ClipVertex<N>> polygon;
    for (const std::uint32_t vertex : pass.mesh().face(item & raster::face_mask)) {
        auto& corner = polygon.emplace_back();
        corner.position = clip_position(pass, vertex);
        for (std::size_t k = 0; k < N; ++k)
            corner.attributes[k] = pass.attributes.streams[k].at(vertex, item);
    }
    return polygon;
}

template <int N>
std::vector<raster::ScreenVertex<N>> projected(const ObjectPass& pass,
                                               const std::vector<raster::ClipVertex<N>>& polygon) {
    return pass.attributes.perspective_correct
               ? raster::project_correct(polygon, pass.frame->viewport)
               : raster::project_affine(polygon, pass.frame->viewport);
}

}  // namespace

glm::vec4 clip_position(const ObjectPass& pass, std::uint32_t vertex) {
    const glm::dvec3 position(pass.mesh().vertices.position(vertex));
    return glm::vec4(transformed_point(pass.placing.clip_from_object, position));
}

std::vector<raster::ScreenVertex<0>> clipped_face(const ObjectPass& pass, std::size_t face) {
    return projected(pass, raster::clip(gathered<0>(pass, static_cast<raster::FaceItem>(face))));
}

template <int N>
void WalkedPolygons::record_all(const ObjectPass& pass, raster::VisibleBand& band,
                                raster::VisibleItems& visible) {
    auto& filler = std::get<raster::PolygonFiller<N>>(fillers_);
    for (std::size_t i = 0; i < visible.walked().size(); ++i) {
        const raster::FaceItem face = visible.walked()[i];
        const auto corners = projected(pass, raster::clip(gathered<N>(pass, face)));
        raster::record_spans<N>(corners, face, raster::VisibleItems::tag(i), filler, band, visible);
    }
}

void WalkedPolygons::record(const ObjectPass& pass, raster::VisibleBand& band,
                            raster::VisibleItems& visible) {
    if (visible.walked().empty()) return;
    switch (pass.attributes.count) {
        case 3:
            return record_all<3>(pass, band, visible);
        case 4:
            return record_all<4>(pass, band, visible);
        case 7:
            return record_all<7>(pass, band, visible);
        default:
            assert(false && "no technique has so many attributes");
    }
}

}  // namespace scanlight::render
