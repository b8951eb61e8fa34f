#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

struct HalfEdgeMesh;

/// How the normals of the faces around a vertex are summed.
enum class NormalWeight {
    mean,   // N_a = (1/k) sum N_i, the chapter's; Gouraud 1971
    area,   // by the area of each face
    angle,  // by the angle of each face at the vertex; Thuermer & Wuethrich 1998
    file,   // the file's own corner normals; where it has none, the mean
};

struct NormalRule {
    NormalWeight weight = NormalWeight::mean;
    /// Faces that meet at a larger angle than this do not share a normal, so that a cube keeps
    /// its edges. 180 smooths over every edge.
    float crease_deg = 60.0f;
};

/// A unit normal for every corner of `mesh.polygons`, object space, from faces that hang together
/// over smooth edges around the corner's vertex. Where a point was split into several vertices, as
/// between solids that touch or at the foot of a third face, each averages over its own fan: the
/// faces one could walk around the point without leaving the surface or changing its orientation.
///
/// Always unit and finite: a sum that vanishes (below 1e-9 of its terms) leaves each corner the
/// normal of its face, and so does a vanishing normal of the file.
std::vector<glm::vec3> corner_normals(const PolygonSoup& soup, const HalfEdgeMesh& mesh,
                                      const NormalRule& rule);

}  // namespace scanlight::mesh
