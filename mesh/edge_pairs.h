#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/group.h"
#include "mesh/polygons.h"

namespace scanlight::mesh {

/// Which half-edges are the two sides of one edge.
struct EdgePairs {
    static constexpr std::uint32_t none = 0xffffffffu;

    std::vector<std::uint32_t> partner;  // one a half-edge; none on a boundary
    Groups crowded;  // the half-edges of each edge with a third face or with faces of opposite
                     // orientation, in ascending order
    std::vector<bool> left_over;  // one a face: on some edge others were paired and it was not

    void part(std::uint32_t half_edge);
};

/// Pairs half-edges that join the same points in opposite directions and belong to different
/// faces. Where an edge has more than two faces, each is paired with the one that bounds the same
/// wedge of the inside (the next one, turning about the edge to the back of the face), so that
/// solids that touch in an edge stay themselves and the order of faces does not matter; among faces
/// in one place, as repeated ones are, the first in the file goes first. Half-edges of corners that
/// must stand alone have no partner. O(n log n) at worst.
EdgePairs pair_edges(const PolygonSoup& soup, const Polygons& polygons);

}  // namespace scanlight::mesh
