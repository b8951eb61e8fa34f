#pragma once

#include <cstdint>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// The square -1 to 1 in x and z, facing +y, in n x n quads. With uv.
PolygonSoup plane(std::uint32_t n);

/// A regular polygon of radius 1 in the xy plane, facing +z; one corner is at (0, 1). With uv.
PolygonSoup regular_polygon(std::uint32_t n);

/// A concave polygon of 2 n corners in the xy plane, facing +z: radius 1 and 0.4 in turn, the first
/// at (0, 1). With uv.
PolygonSoup star(std::uint32_t points);

}  // namespace scanlight::mesh
