#pragma once

#include "raster/framebuffer.h"
#include "render/scene.h"

namespace scanlight::render {

/// Which lines of a wireframe show: all, or those that the depth buffer does not hide.
enum class HiddenLines { shown, removed };

/// Draws the edges of all polygons but the culled over what is there, in one colour. For `removed`,
/// draw the polygons first (`draw_depth` is enough): lines lie on surfaces, so a line passes if it
/// is less than 1/1000 of the depth range, and a pixel's step along the surface, behind what is
/// stored. Of the settings only `cull` counts.
void draw_wireframe(const Scene& scene, raster::Rgba color, HiddenLines hidden,
                    raster::Framebuffer& target, const Settings& settings = {});

}  // namespace scanlight::render
