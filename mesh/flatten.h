#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

struct Polygons;

/// Unit normals, object space.
struct Normals {
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> faces;
};

/// The drawable faces of a soup as plain arrays, in their order. Vertices are numbered by first
/// use, one for every distinct (point, normal, uv, material), so that a vertex can be lit by its
/// own material; the colour goes with the point. `normals` are those of all corners and faces of
/// `polygons`. A corner without uv gets (0, 0) if others have some; a soup without materials gets a
/// default one.
Mesh flatten(const PolygonSoup& soup, Polygons polygons, Normals normals);

}  // namespace scanlight::mesh
