#pragma once

#include <cstdint>

#include "apps/scanlight/model.h"
#include "apps/scanlight/scene_options.h"
#include "raster/image.h"
#include "render/draw.h"

namespace scanlight::apps {

/// Draws the scene and, as the options ask, the edges of its polygons.
render::Drawing draw_picture(const render::Scene& scene, const SceneOptions& options);

/// Normals as colours: (n + 1) / 2 in 8 bits; black is the background.
raster::Image8 normals_image(const raster::Plane<glm::vec3>& normals);

/// World-space normals as floats.
raster::ImageF normals_float_image(const raster::Plane<glm::vec3>& normals);

/// Polygon numbers in 24 bits: red is the highest byte, blue the lowest; or as floats.
raster::Image8 ids_image(const raster::Plane<std::uint32_t>& ids);
raster::ImageF ids_float_image(const raster::Plane<std::uint32_t>& ids);

/// One float a pixel.
raster::ImageF float_image(const raster::Plane<float>& values);

}  // namespace scanlight::apps
