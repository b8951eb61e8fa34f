#pragma once

#include <cstdint>
#include <span>

#include "raster/framebuffer.h"
#include "render/scene.h"
#include "render/shadow_polygons.h"
#include "render/wireframe.h"

namespace scanlight::render {

/// Where details are seen: 1, elsewhere 0. A detail lies in its face's own plane, so that it has
/// its face's depth and is seen where that is, from the side of the light: an item buffer says
/// where. So faces in one plane do not fight.
raster::Plane<std::uint8_t> draw_details(const Scene& scene, const Settings& settings,
                                         std::span<const DetailPolygon> details,
                                         raster::Viewport viewport);

/// Draws the outlines of details over what is there, in one colour, but where the depth buffer
/// hides them.
void draw_detail_outlines(const Scene& scene, std::span<const DetailPolygon> details,
                          raster::Rgba color, raster::Framebuffer& target);

}  // namespace scanlight::render
