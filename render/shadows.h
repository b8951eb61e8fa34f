#pragma once

#include <cstddef>
#include <cstdint>

#include "render/draw.h"

namespace scanlight::render {

/// How many shadow volumes of a light each pixel's surface lies in; not 0 is in shadow. `light` is
/// its place among those of the scene; `depth` is that of the scene without shadows.
raster::Plane<std::int32_t> count_shadows(const Scene& scene, const Settings& settings,
                                          std::size_t light,
                                          const raster::Plane<raster::Depth>& depth);

/// Draws a scene with shadows, in many passes as in the literature: the ambient light first, then
/// for each light the shadow volumes into the stencil, and the light where nothing was counted.
/// A pixel in the shadow of all lights has the colour of the ambient picture, to the bit.
Drawing draw_with_shadows(const Scene& scene, const Settings& settings, raster::Viewport viewport);

}  // namespace scanlight::render
