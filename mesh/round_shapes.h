#pragma once

#include <cstdint>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

// Object space, y up, faces outward. Around the y axis angles run from +z to +x, so that u grows to
// the right; v grows upward. Where u or v begins again, one point has two of them.

/// The unit sphere as an icosahedron whose triangles are cut in four `level` times.
PolygonSoup icosphere(std::uint32_t level);

/// The unit sphere in slices and stacks: quads, triangles at the poles. With uv.
PolygonSoup uv_sphere(std::uint32_t slices, std::uint32_t stacks);

/// The same sphere with waves on it, up to 0.03 high: those of the texture of that name, 8 of them
/// round a spherical mapping about the y axis. With uv.
PolygonSoup wavy_sphere(std::uint32_t slices, std::uint32_t stacks);

/// Around the y axis; radius 0.7 to the middle of the tube, which has radius 0.3. With uv.
PolygonSoup torus(std::uint32_t segments, std::uint32_t sides);

/// Radius 1, y from -1 to 1; each end is one polygon. With uv.
PolygonSoup cylinder(std::uint32_t segments);

/// Radius 1 at y = -1, where one polygon closes it, up to (0, 1, 0).
PolygonSoup cone(std::uint32_t segments);

}  // namespace scanlight::mesh
