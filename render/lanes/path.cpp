#include "render/lane_path.h"

#include "render/lanes/light_vertices.h"
#include "render/lanes/shade.h"
#include "render/lanes/store.h"
#include "render/lanes/vertices.h"

namespace scanlight::raster::HWY_NAMESPACE {
extern const LanePath lane_path;
}

namespace scanlight::render::HWY_NAMESPACE {

namespace {

std::int32_t place_vertices(ObjectPass& pass, std::size_t begin, std::size_t end) {
    return VertexPlacer(pass.placing, pass.frame->viewport, pass.vertices)
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

template <class Technique>
std::size_t shade_rows(const Technique& technique, raster::VisibleBand& band, ShadeScratch& scratch,
                       const Target& target, Background background) {
    scratch.row.resize(static_cast<std::size_t>(band.width()) + raster::most_lanes);
    std::size_t pixels = 0;
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        technique.shade_row(band, y);
        pixels += store_row(scratch.row, band, y, target, background);
    }
    return pixels;
}

std::size_t shade_band(const ObjectPass& pass, raster::VisibleBand& band, ShadeScratch& scratch,
                       const Target& target, Background background) {
    const auto shade = [&](const auto& technique) {
        return shade_rows(technique, band, scratch, target, background);
    };
    switch (pass.settings->shading) {
        case Shading::flat:
            return shade(FlatLanes(pass, scratch));
        case Shading::gouraud:
            return shade(PixelByPixel(GouraudLanes(pass), scratch));
        case Shading::phong:
            break;
    }
    return with_model(*pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            const PhongLanes<decltype(model), paint> technique(pass, scratch, model);
            return shade(PixelByPixel(technique, scratch));
        });
    });
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{&raster::HWY_NAMESPACE::lane_path, place_vertices, light_vertices,
                         set_up_planes, shade_band};

}  // namespace scanlight::render::HWY_NAMESPACE
