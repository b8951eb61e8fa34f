#pragma once

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// The same mesh with every polygon cut into triangles in object space (by ear clipping, convex or
/// concave), so that interpolation no longer depends on how the polygon is turned on the screen.
/// A triangle keeps its polygon's normal, material and id.
Mesh triangulated(const Mesh& mesh);

}  // namespace scanlight::mesh
