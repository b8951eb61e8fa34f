#pragma once

#include <array>
#include <optional>

#include "raster/image.h"
#include "shading/environment.h"

namespace scanlight::render {

/// The six sides of a cube, each upright, in the order of `EnvironmentLayout::cube`.
using CubeSides = std::array<raster::AnyImage, 6>;

/// From the world's axes to those of pictures of a cube's sides, which show ahead, towards -z, what
/// they call +z: so that right is right to one who stands inside.
inline constexpr glm::mat3 cube_from_world{1, 0, 0, 0, 1, 0, 0, 0, -1};

/// The sides from a picture in which they lie side by side: in a row or a column, in their order,
/// or in a cross of 4 x 3, or of 3 x 4 with the last one upside down below (Debevec's). None where
/// the picture has no such shape.
std::optional<CubeSides> cube_sides(const raster::AnyImage& picture);

/// What surrounds one who stands in such a cube. None where there are too many texels.
std::optional<shading::Environment> cube_environment(const CubeSides& sides);

}  // namespace scanlight::render
