#pragma once

#include "raster/image.h"
#include "shading/surface_textures.h"

namespace scanlight::peers {

/// What a stage's mesh wears over its material: an image by its own (u, v), trilinear, as diffuse
/// colour or as the height of a bump map.
enum class Coat { none, texture, bump };

/// How often the image lies along u and along v.
inline constexpr float coat_repeat = 4;
/// How high white is, world units.
inline constexpr float coat_height = 0.01f;

/// The image: sRGB-coded colours, or heights, one channel. Requires a coat.
raster::Image8 coat_image(Coat coat);

shading::SurfaceTextures coat_textures(Coat coat);

}  // namespace scanlight::peers
