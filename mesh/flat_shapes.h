#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// The square -1 to 1 in x and z, facing +y, in n x n quads. With uv.
PolygonSoup plane(std::uint32_t n);

/// A regular polygon of radius 1 in the xy plane, facing +z; one corner is at (0, 1). With uv.
PolygonSoup regular_polygon(std::uint32_t n);

/// A concave polygon of 2 n corners in the xy plane, facing +z: radius 1 and 0.4 in turn, the first
/// at (0, 1). With uv.
PolygonSoup star(std::uint32_t points);

/// The polygon with these corners in the xy plane, facing +z: those that go clockwise are taken the
/// other way round, from the same first one on. It may be concave, and cross itself; where its
/// areas cancel, it may begin with another corner. With uv. Throws FileError for one without an
/// area.
PolygonSoup flat_polygon(std::span<const glm::dvec2> corners);

}  // namespace scanlight::mesh
