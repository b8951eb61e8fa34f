#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "raster/lane_path.h"
#include "render/object_pass.h"
#include "render/shadow_band.h"

namespace scanlight::render {

/// A row of a layer of transparent surfaces.
struct LayerRow {
    VectorStreams color;
    std::vector<float> opacity;

    void resize(std::size_t n) {
        color.resize(n);
        opacity.resize(n);
    }
};

/// The vector code of this room for one instruction set. All sets give the same bits.
struct LanePath {
    const raster::LanePath* raster;

    /// Vertices [begin, end) of the object to the screen; begin a multiple of 64. The clip planes
    /// beyond which any of them lies.
    std::int32_t (*place_vertices)(ObjectPass&, std::size_t begin, std::size_t end);

    /// Illuminates vertices [begin, end), begin a multiple of 64. The largest finite channel.
    float (*light_vertices)(ObjectPass&, std::size_t begin, std::size_t end);

    /// Fills in `face_uvs` of faces [begin, end).
    void (*find_face_uvs)(ObjectPass&, std::size_t begin, std::size_t end);

    /// Draws polygons of the object into the band. Pixels keep their colour where there is
    /// `light_at_once`; else the polygon's item and the object's attributes.
    void (*see)(const ObjectPass&, std::span<const raster::FaceItem> items,
                std::optional<raster::Encoding> at_once, raster::VisibleBand&, raster::Walker&);

    /// Stores the colours that the pixels keep; all others become background.
    void (*store_band)(raster::VisibleBand&, const Target&);

    /// Illuminates each pixel of the band that shows the object, by what it keeps, and stores it.
    /// Returns how many there were. With `Background::drawn` all others become background.
    /// `shadows` may be null.
    std::size_t (*light_band)(const ObjectPass&, raster::VisibleBand&, const ShadowBand* shadows,
                              const Target&, Background);

    /// Draws polygons of a transparent object into a layer of the band, see
    /// `VisibleBand::begin_layers`. Pixels keep the polygon's item and the object's attributes.
    void (*see_behind)(const ObjectPass&, std::span<const raster::FaceItem> items,
                       raster::VisibleBand&, raster::Walker&);

    /// Illuminates the pixels of a row that show the object. The others are any. The row has room
    /// for the band's width and a vector.
    void (*light_layer_row)(const ObjectPass&, raster::VisibleBand&, const ShadowBand* shadows,
                            int y, LayerRow&);
};

/// Those that this machine can run, the fastest first; never empty.
std::span<const LanePath* const> lane_paths();

}  // namespace scanlight::render
