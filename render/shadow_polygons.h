#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec4.hpp>

#include "render/flat_polygons.h"

namespace scanlight::render {

/// A part of a face, flat, cut along the edges of others: the detail polygons of Atherton, Weiler &
/// Greenberg 1978, "Polygon shadow generation", SIGGRAPH.
struct DetailPolygon {
    std::size_t object = 0;  // whose it is: a place in the scene
    std::size_t face = 0;    // of the object's mesh
    bool whole = false;      // all of the face
    OrientedPlane plane;     // the face's, turned to the light; of a bent one the mean plane
    /// In the face's plane, world space; what lies inside an odd number of them. They run
    /// counter-clockwise as the light sees them, and holes clockwise; that of a whole face as the
    /// face does. Triangles of a bent face, and the views of a point light, have outlines of their
    /// own.
    std::vector<Corners> outlines;
};

/// Which part of a face.
enum class LightPart {
    lit,       // what the light sees of it
    shadowed,  // the rest
};

/// The parts of all faces, from either side, in their order; without faces that have none, and
/// without those that the light sees edge-on. `light` is homogeneous, world space.
///
/// In the light's view, hidden surfaces are removed by polygon clipping (Weiler & Atherton 1977,
/// "Hidden surface removal using polygon area sorting", SIGGRAPH), and what is left is carried back
/// into the faces' planes. Of two polygons one over the other that which lies before the other's
/// plane is nearer; one that goes through the plane is cut there. So no order has to be found, and
/// polygons may go through or round one another. What lies in a plane shadows nothing in it.
///
/// Time: each face is clipped against those over it. In the worst case, many large faces over one
/// another, it grows with their number squared.
std::vector<DetailPolygon> detail_polygons(const std::vector<Object>& objects,
                                           const glm::dvec4& light,
                                           LightPart part = LightPart::lit);

}  // namespace scanlight::render
