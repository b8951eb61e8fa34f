#pragma once

#include <cstddef>

#include "mesh/mesh.h"
#include "mesh/normals.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// What became of the faces: `faces_in == drawn + zero_area + few_corners`.
struct BuildReport {
    std::size_t faces_in = 0;
    std::size_t drawn = 0;
    std::size_t zero_area = 0;        // dropped: nothing to fill
    std::size_t few_corners = 0;      // dropped: fewer than 3 distinct corners
    std::size_t split_faces = 0;      // kept with corners of their own: an edge with a third face,
                                      // a repeated face, neighbours of opposite orientation
    std::size_t split_vertices = 0;   // vertices added where surfaces touch in a point
    std::size_t isolated_points = 0;  // points that no drawn face uses

    // Of the half-edge mesh, after splitting; a crease does not double a vertex here.
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t boundary_edges = 0;
    std::size_t components = 0;  // pieces that hang together over edges

    bool closed() const { return drawn > 0 && boundary_edges == 0; }
    bool manifold() const { return split_faces == 0 && split_vertices == 0; }
    /// V - E + F: 2 for a ball, 0 for a torus, summed over the components.
    std::ptrdiff_t euler_number() const {
        return static_cast<std::ptrdiff_t>(vertices + drawn) - static_cast<std::ptrdiff_t>(edges);
    }
};

struct BuiltMesh {
    Mesh mesh;
    BuildReport report;
};

/// Polygons into an OpenMesh half-edge mesh, its vertex normals, and out again as plain arrays.
/// No face is lost: what a half-edge mesh cannot hold is split first. Faces keep their order.
/// Points are joined by index, not by place: what a file keeps apart stays apart.
BuiltMesh build(const PolygonSoup& soup, const NormalRule& rule = {});

}  // namespace scanlight::mesh
