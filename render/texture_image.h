#pragma once

#include <memory>

#include "raster/image.h"
#include "shading/texel_image.h"

namespace scanlight::render {

/// What the numbers of an image file stand for: colours (8 and 16 bits: sRGB-encoded), or measured
/// values such as heights and normals, 0 to 1 as they are.
enum class TexelMeaning { color, value };

/// Which row of a picture is at v = 0.
enum class RowAtZero { lowest, highest };

/// The most texels an image texture may have: with its pyramid they take some 360 MB.
inline constexpr int most_texels = 1 << 25;

/// A texture of a picture. Grey becomes red, green and blue alike; without alpha it is 1. None
/// where there are more than `most_texels`.
std::shared_ptr<const shading::TexelImage> texel_image(const raster::AnyImage& image,
                                                       TexelMeaning meaning,
                                                       RowAtZero zero = RowAtZero::lowest);

}  // namespace scanlight::render
