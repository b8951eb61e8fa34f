#pragma once

#include <cstdint>
#include <vector>

#include "mesh/edge_pairs.h"
#include "mesh/polygons.h"

namespace scanlight::mesh {

/// The vertices of a half-edge mesh: one for every fan, the corners around a point that hang
/// together over paired edges. A point where several fans touch gets several vertices.
struct Fans {
    std::vector<std::uint32_t> vertex;  // one a corner
    std::vector<std::uint32_t> point;   // one a vertex, into the soup's positions

    std::size_t vertex_count() const { return point.size(); }
};

/// Numbers the fans by their first corners.
Fans find_fans(const Polygons& polygons, const EdgePairs& pairs);

/// Two edges between the same two vertices, which a half-edge mesh cannot hold, are possible only
/// among crowded edges: the first stays, the corners of the others get vertices of their own.
/// Marks the faces of these corners as left over.
Fans separate_double_edges(const Polygons& polygons, EdgePairs& pairs, Fans fans);

}  // namespace scanlight::mesh
