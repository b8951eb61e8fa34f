#pragma once

#include <cstdint>

#include "raster/framebuffer.h"
#include "render/draw_polygons.h"
#include "render/scene.h"

namespace scanlight::render {

struct Drawing {
    raster::Framebuffer framebuffer;
    DrawCounts counts;
};

/// Draws a scene: hidden surfaces removed by a z-buffer, polygons in the order of the objects and
/// of their faces. The same picture, to the bit, on every machine.
Drawing draw(const Scene& scene, const Settings& settings, raster::Viewport viewport);

/// The same, all surfaces taken for opaque.
Drawing draw_opaque(const Scene& scene, const Settings& settings, raster::Viewport viewport);

/// The same in the background's colour, unlit: what is in front hides what comes later.
Drawing draw_depth(const Scene& scene, const Settings& settings, raster::Viewport viewport);

/// The same of the opaque surfaces alone: the depth that belongs to the picture.
Drawing draw_opaque_depth(const Scene& scene, const Settings& settings, raster::Viewport viewport);

/// How much of the light a smooth surface of the same material would mirror into the eye, by
/// Fresnel's equations; in the place of the light.
Drawing draw_fresnel(const Scene& scene, const Settings& settings, raster::Viewport viewport);

/// The normals that Phong shading lights: unit, world space; zero where nothing is.
raster::Plane<glm::vec3> draw_normals(const Scene& scene, const Settings& settings,
                                      raster::Viewport viewport);

/// Which polygon each pixel shows: its place in its file plus 1, counted on over the objects;
/// 0 where nothing is.
raster::Plane<std::uint32_t> draw_ids(const Scene& scene, const Settings& settings,
                                      raster::Viewport viewport);

/// Which face each pixel shows: its place among those of all objects plus 1; 0 where nothing is.
raster::Plane<std::uint32_t> draw_items(const Scene& scene, const Settings& settings,
                                        raster::Viewport viewport);

/// Distance from the eye along the view, in world units; 0 where nothing is.
raster::Plane<float> eye_distances(const raster::Plane<raster::Depth>& depth, const Camera& camera);

}  // namespace scanlight::render
