#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace scanlight::mesh {

/// Cuts a polygon into its n - 2 triangles, corners as places in `polygon`, turning the way the
/// polygon turns. Ear clipping (Meisters 1975, "Polygons have ears") on the plane that the
/// polygon's area vector faces most, in double, over a grid of the corners that can be in the way:
/// O(n) when convex, near it for most, O(n^2) at worst.
///
/// Exact area for a simple polygon. One that crosses itself, or has no area, still gets n - 2
/// triangles: where no ear is left the next corner that turns the right way is cut, or else any.
std::vector<std::array<std::uint32_t, 3>> cut_ears(std::span<const glm::vec3> polygon);

}  // namespace scanlight::mesh
