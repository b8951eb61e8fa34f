#pragma once

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Platonic solids with corners at -1 and 1. Object space, faces outward.
PolygonSoup cube();
PolygonSoup tetrahedron();
PolygonSoup octahedron();

}  // namespace scanlight::mesh
