#pragma once

#include <cstddef>

#include "raster/framebuffer.h"
#include "render/scene.h"

namespace scanlight::render {

/// How much of a light reaches what each pixel shows, from 0 to 1, by the settings' method: 1 where
/// nothing is in its way. `light` is its place among those of the scene; `depth` is that of the
/// scene without shadows. Pixels that show nothing may have any share.
raster::Plane<float> lit_share(const Scene& scene, const Settings& settings, std::size_t light,
                               const raster::Plane<raster::Depth>& depth);

}  // namespace scanlight::render
