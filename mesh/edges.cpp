#include "mesh/edges.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/weld.h"

namespace scanlight::mesh {

namespace {

/// Of each vertex, the first one of its position.
std::vector<std::uint32_t> points_of(const Vertices& vertices) {
    Welder welder(vertices.size());
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> result(vertices.size());
    for (std::uint32_t v = 0; v < result.size(); ++v) {
        const std::uint32_t point = welder.index_of(vertices.position(v));
        if (point == first.size()) first.push_back(v);
        result[v] = first[point];
    }
    return result;
}

struct Side {
    std::uint32_t from, to, face;
    std::int32_t direction;

    friend bool operator<(const Side& a, const Side& b) {
        return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
    }
};

Side side(std::uint32_t a, std::uint32_t b, std::uint32_t face) {
    return a < b ? Side{a, b, face, 1} : Side{b, a, face, -1};
}

std::vector<Side> sides_of(const Mesh& mesh) {
    const auto point = points_of(mesh.vertices);
    std::vector<Side> sides;
    sides.reserve(mesh.corners.size());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = mesh.face(f);
        std::uint32_t a = point[corners.back()];
        for (const std::uint32_t corner : corners) {
            const std::uint32_t b = point[corner];
            if (a != b) sides.push_back(side(a, b, f));
            a = b;
        }
    }
    std::ranges::stable_sort(sides, std::less<>{});
    return sides;
}

}  // namespace

Edges edges_of(const Mesh& mesh) {
    Edges edges;
    edges.use_begin.clear();
    for (const auto& [from, to, face, direction] : sides_of(mesh)) {
        if (edges.from.empty() || edges.from.back() != from || edges.to.back() != to) {
            edges.use_begin.push_back(static_cast<std::uint32_t>(edges.uses.size()));
            edges.from.push_back(from);
            edges.to.push_back(to);
        }
        edges.uses.push_back({face, direction});
    }
    edges.use_begin.push_back(static_cast<std::uint32_t>(edges.uses.size()));
    return edges;
}

}  // namespace scanlight::mesh
