#pragma once

#include "raster/framebuffer.h"
#include "render/scene.h"

namespace scanlight::render {

/// Which lines of a wireframe show: all, or those that the depth buffer does not hide.
enum class HiddenLines { shown, removed };

/// Draws the edges of all polygons over what is there, in one colour. For `removed`, draw the
/// polygons first: lines lie on surfaces, so a line passes if it is less than 1/1000 of the depth
/// range, and a pixel's step along the surface, behind what is stored.
void draw_wireframe(const Scene& scene, raster::Rgba color, HiddenLines hidden,
                    raster::Framebuffer& target);

}  // namespace scanlight::render
