#pragma once

#include "raster/framebuffer.h"
#include "raster/vertex.h"
#include "render/scene.h"

namespace scanlight::render {

/// Which lines of a wireframe show: all, or those that the depth buffer does not hide.
enum class HiddenLines { shown, removed };

/// Draws a line that lies on a surface, but where the depth buffer, drawn by this camera, hides it:
/// it passes if it is less than 1/1000 of its distance, of an orthographic camera of the depth
/// range, and a pixel's step along the surface, behind what is stored.
void draw_visible_line(const raster::ScreenVertex<0>& a, const raster::ScreenVertex<0>& b,
                       const Camera& camera, raster::Rgba color, raster::Framebuffer& target);

/// Draws the edges of all polygons but the culled over what is there, in one colour. For `removed`,
/// draw the polygons first (`draw_depth` is enough): see `draw_visible_line`. Of the settings only
/// `cull` counts.
void draw_wireframe(const Scene& scene, raster::Rgba color, HiddenLines hidden,
                    raster::Framebuffer& target, const Settings& settings = {});

}  // namespace scanlight::render
