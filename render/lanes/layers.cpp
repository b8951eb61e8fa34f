#include "render/lanes/layers.h"

#include "raster/lanes/band_painter.h"
#include "raster/lanes/keep.h"
#include "render/lanes/light_row.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

namespace {

/// `KeepAttributes` of what lies behind the layer before.
template <int count>
class KeepBehind : public KeepAttributes<count> {
public:
    KeepBehind(std::int32_t first, int before) : KeepAttributes<count>(first), before_(before) {}

    /// Of the same depth, what comes later is behind.
    Mask is_behind(Ints z, Ints own, raster::PixelPlace at) const {
        const Ints depth = load(at.kept(before_));
        const Ints faces(static_cast<std::int32_t>(raster::face_mask));
        const Mask later = (load(at.kept(before_ + 1)) & faces) < (own & faces);
        return (depth < z) | ((z == depth) & later);
    }
    bool is_behind(raster::Depth z, std::int32_t own, raster::PixelPlace at) const {
        const raster::Depth depth = *at.kept(before_);
        const auto face = [](std::int32_t number) {
            return static_cast<raster::FaceItem>(number) & raster::face_mask;
        };
        return depth < z || (z == depth && face(*at.kept(before_ + 1)) < face(own));
    }

private:
    int before_;  // the first of the two numbers kept of that layer
};

template <int count>
void draw(const ObjectPass& pass, std::span<const raster::FaceItem> items,
          raster::VisibleBand& band, raster::Walker& walker) {
    const KeepBehind<count> keep(pass.faces.first, band.layer_before());
    BandPainter<KeepBehind<count>>(pass.polygons, pass.attributes, keep, band, walker).draw(items);
}

}  // namespace

void see_behind(const ObjectPass& pass, std::span<const raster::FaceItem> items,
                raster::VisibleBand& band, raster::Walker& walker) {
    switch (pass.attributes.count) {
        case 3:
            return draw<3>(pass, items, band, walker);
        case 4:
            return draw<4>(pass, items, band, walker);
        case 6:
            return draw<6>(pass, items, band, walker);
        case 7:
            return draw<7>(pass, items, band, walker);
        case 9:
            return draw<9>(pass, items, band, walker);
        default:
            return draw<0>(pass, items, band, walker);
    }
}

void light_layer_row(const ObjectPass& pass, raster::VisibleBand& band, const ShadowBand* shadows,
                     int y, LayerRow& row) {
    StreamRow colors(row.color);
    light_row(pass, band, shadows, y, colors);
    find_row_opacity(pass, band, y, row.opacity);
}

}  // namespace scanlight::render::HWY_NAMESPACE
