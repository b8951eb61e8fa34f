#include "render/lane_path.h"

#include "render/lanes/light_vertices.h"
#include "render/lanes/shade.h"
#include "render/lanes/vertices.h"

namespace scanlight::raster::HWY_NAMESPACE {
extern const LanePath lane_path;
}

namespace scanlight::render::HWY_NAMESPACE {

namespace {

void place_vertices(ObjectPass& pass, std::size_t begin, std::size_t end) {
    VertexPlacer(pass.placing, pass.frame->viewport, pass.vertices)
        .place(pass.mesh().vertices, begin, end);
}

float light_vertices(ObjectPass& pass, std::size_t begin, std::size_t end) {
    return with_model(*pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            return VertexLighter<decltype(model), paint>(pass, model).light(begin, end);
        });
    });
}

void set_up_planes(const ObjectPass& pass, raster::AttributeRecords& records) {
    PlaneRecorder(pass.polygons, pass.attributes).set_up(records);
}

template <class Pixels>
std::size_t shade_into(const ObjectPass& pass, raster::VisibleBand& band, ShadeScratch& scratch,
                       const Pixels& to) {
    const auto& records = scratch.records;
    switch (pass.settings->shading) {
        case Shading::flat:
            return shade_pixels(FlatLanes(pass, scratch), records, band, to);
        case Shading::gouraud:
            return shade_pixels(GouraudLanes(pass, scratch), records, band, to);
        case Shading::phong:
            break;
    }
    return with_model(*pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            using Technique = PhongLanes<decltype(model), paint>;
            return shade_pixels(Technique(pass, scratch, model), records, band, to);
        });
    });
}

std::size_t shade_band(const ObjectPass& pass, raster::VisibleBand& band, ShadeScratch& scratch,
                       const Target& target) {
    if (const auto* floats = std::get_if<FloatTarget>(&target)) {
        return shade_into(pass, band, scratch, FloatPixels{*floats->plane});
    }
    const auto& packed = std::get<PackedTarget>(target);
    if (packed.encoding == raster::Encoding::srgb) {
        return shade_into(pass, band, scratch, PackedPixels<raster::Encoding::srgb>{*packed.plane});
    }
    return shade_into(pass, band, scratch, PackedPixels<raster::Encoding::linear>{*packed.plane});
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{&raster::HWY_NAMESPACE::lane_path, place_vertices, light_vertices,
                         set_up_planes, shade_band};

}  // namespace scanlight::render::HWY_NAMESPACE
