#include "render/lane_path.h"

#include "raster/lanes/band_painter.h"
#include "render/lanes/face_uvs.h"
#include "render/lanes/keep_color.h"
#include "render/lanes/layers.h"
#include "render/lanes/light_row.h"
#include "render/lanes/light_vertices.h"
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
    return with_model(pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            return VertexLighter<decltype(model), paint>(pass, model).light(begin, end);
        });
    });
}

template <class Keep>
void draw(const ObjectPass& pass, std::span<const raster::FaceItem> items, const Keep& keep,
          raster::VisibleBand& band, raster::Walker& walker) {
    BandPainter<Keep>(pass.polygons, pass.attributes, keep, band, walker).draw(items);
}

void see_colors(const ObjectPass& pass, std::span<const raster::FaceItem> items,
                raster::Encoding encoding, raster::VisibleBand& band, raster::Walker& walker) {
    if (pass.settings.shading == Shading::flat)
        return draw(pass, items, KeepFlatColor(pass, encoding), band, walker);
    if (encoding == raster::Encoding::srgb)
        return draw(pass, items, KeepGouraudColor<raster::Encoding::srgb>(pass), band, walker);
    draw(pass, items, KeepGouraudColor<raster::Encoding::linear>(pass), band, walker);
}

void see(const ObjectPass& pass, std::span<const raster::FaceItem> items,
         std::optional<raster::Encoding> at_once, raster::VisibleBand& band,
         raster::Walker& walker) {
    if (at_once) return see_colors(pass, items, *at_once, band, walker);
    const std::int32_t first = pass.faces.first;
    switch (pass.attributes.count) {
        case 3:
            return draw(pass, items, KeepAttributes<3>(first), band, walker);
        case 4:
            return draw(pass, items, KeepAttributes<4>(first), band, walker);
        case 6:
            return draw(pass, items, KeepAttributes<6>(first), band, walker);
        case 7:
            return draw(pass, items, KeepAttributes<7>(first), band, walker);
        case 9:
            return draw(pass, items, KeepAttributes<9>(first), band, walker);
        default:
            raster::HWY_NAMESPACE::lane_path.draw_items(pass.polygons, items, first, band, walker);
    }
}

void store_band(raster::VisibleBand& band, const Target& target) {
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y)
        store_pixels(band, y, *std::get_if<PackedTarget>(&target));
}

std::size_t light_band(const ObjectPass& pass, raster::VisibleBand& band, const ShadowBand* shadows,
                       const Target& target, Background background) {
    std::size_t pixels = 0;
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        with_row(target, background, band.touched(), y,
                 [&](auto&& row) { pixels += light_row(pass, band, shadows, y, row); });
    }
    return pixels;
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{&raster::HWY_NAMESPACE::lane_path,
                         place_vertices,
                         light_vertices,
                         find_face_uvs,
                         see,
                         store_band,
                         light_band,
                         see_behind,
                         light_layer_row};

}  // namespace scanlight::render::HWY_NAMESPACE
