#pragma once

#include <cstdint>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Martin Newell's teapot (1975, University of Utah), with the bottom that was added later, in
/// n x n quads for each of its 32 bicubic Bezier patches, triangles where a patch closes in a
/// point. Patches share the points of their seams. The lid, handle and spout only touch or enter
/// the body, as in the original, so that the surface is open at their ends. y up, the spout towards
/// +x; half the original's size: x from -1.5 to 1.717, y from -0.7875 to 0.7875.
PolygonSoup teapot(std::uint32_t n);

}  // namespace scanlight::mesh
