#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/draw.h"

namespace scanlight::render {

/// How many shadow volumes of a light each pixel's surface lies in; not 0 is in shadow. `light` is
/// its place among those of the scene; `depth` is that of the scene without shadows.
raster::Plane<std::int32_t> count_shadows(const Scene& scene, const Settings& settings,
                                          std::size_t light,
                                          const raster::Plane<raster::Depth>& depth);

/// What a face of a shadow volume is.
enum class VolumePart {
    cap,       // a face of the object
    side,      // from an edge of its silhouette away from the light
    end,       // a face again, at infinity
    near_cut,  // what closes the volume where the near plane cuts it open
};

/// A face of a shadow volume that a ray from the eye goes through.
struct ShadowCrossing {
    std::size_t object = 0;  // its place in the scene
    VolumePart part = VolumePart::cap;
    std::uint32_t face = 0;     // of a cap or an end: its place in the file, from 0
    mesh::SilhouetteEdge edge;  // of a side
    std::int32_t entered = 0;   // how many volumes the ray enters there, less those it leaves
    raster::Depth depth = 0;    // `raster::depth_beyond` at infinity, less than 0 on the near plane
};

/// The faces that the ray through pixel (x, y)'s centre goes through, from the eye on.
std::vector<ShadowCrossing> shadow_crossings(const Scene& scene, const Settings& settings,
                                             std::size_t light, raster::Viewport viewport, int x,
                                             int y);

}  // namespace scanlight::render
