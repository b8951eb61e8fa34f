#pragma once

#include <cstddef>
#include <span>

#include "raster/lane_path.h"
#include "render/object_pass.h"

namespace scanlight::render {

/// The vector code of this room for one instruction set. All sets give the same bits.
struct LanePath {
    const raster::LanePath* raster;

    /// Vertices [begin, end) of the object to the screen; begin a multiple of 64. The clip planes
    /// beyond which any of them lies.
    std::int32_t (*place_vertices)(ObjectPass&, std::size_t begin, std::size_t end);

    /// Illuminates vertices [begin, end), begin a multiple of 64. The largest finite channel.
    float (*light_vertices)(ObjectPass&, std::size_t begin, std::size_t end);

    /// Sets up the attributes of those records that are not of spans.
    void (*set_up_planes)(const ObjectPass&, raster::AttributeRecords&);

    /// Illuminates each pixel of the band that has a record, and stores it in the target. Returns
    /// how many there were. With `Background::drawn` all other pixels become background.
    std::size_t (*shade_band)(const ObjectPass&, raster::VisibleBand&, ShadeScratch&, const Target&,
                              Background);
};

/// Those that this machine can run, the fastest first; never empty.
std::span<const LanePath* const> lane_paths();

}  // namespace scanlight::render
