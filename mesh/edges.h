#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// The edges of a mesh, and the faces at each. Vertices of one position are one point here,
/// whatever their normals: the first of them stands for it. Edges may have any number of faces, and
/// faces of any orientation; those whose ends are one point are left out.
struct Edges {
    /// A face that has the edge on its way round.
    struct Use {
        std::uint32_t face;
        std::int32_t direction;  // 1: from `from` to `to`; -1: back
    };

    std::vector<std::uint32_t> from, to;  // vertices, from < to
    std::vector<std::uint32_t> use_begin{0};
    std::vector<Use> uses;

    std::size_t size() const { return from.size(); }
    std::span<const Use> uses_of(std::size_t edge) const {
        return std::span(uses).subspan(use_begin[edge], use_begin[edge + 1] - use_begin[edge]);
    }
};

/// In the order of their vertices; uses in the order of faces. O(n log n).
Edges edges_of(const Mesh& mesh);

}  // namespace scanlight::mesh
