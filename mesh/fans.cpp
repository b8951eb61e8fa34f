#include "mesh/fans.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scanlight::mesh {
namespace {

using Corner = std::uint32_t;
constexpr std::uint32_t none = EdgePairs::none;

/// The corner of the same fan across the edge that leaves this corner.
Corner across_leaving(const Polygons& polygons, const EdgePairs& pairs, Corner corner) {
    const Corner partner = pairs.partner[corner];
    return partner == none ? none : polygons.next(partner);
}

/// The corner of the same fan across the edge that enters this corner.
Corner across_entering(const Polygons& polygons, const EdgePairs& pairs, Corner corner) {
    return pairs.partner[polygons.previous(corner)];
}

/// Marks corners from `corner` on until the fan ends or comes round.
template <class Step>
void spread(Fans& fans, Corner corner, std::uint32_t vertex, Step&& step) {
    while (corner != none && fans.vertex[corner] == none) {
        fans.vertex[corner] = vertex;
        corner = step(corner);
    }
}

using EdgeKey = std::pair<std::array<std::uint32_t, 2>, Corner>;

/// Sorts by the two vertices, then by half-edge.
EdgeKey edge_key(const Polygons& polygons, const Fans& fans, Corner half_edge) {
    const std::uint32_t a = fans.vertex[half_edge];
    const std::uint32_t b = fans.vertex[polygons.next(half_edge)];
    return {{std::min(a, b), std::max(a, b)}, half_edge};
}

/// The half-edges of one crowded edge that join the same vertices as an earlier edge.
std::vector<Corner> doubles(const Polygons& polygons, const EdgePairs& pairs, const Fans& fans,
                            std::span<const Corner> half_edges) {
    std::vector<EdgeKey> keys;
    for (const Corner half_edge : half_edges) {
        keys.push_back(edge_key(polygons, fans, half_edge));
    }
    std::ranges::sort(keys);
    std::vector<Corner> found;
    for (std::size_t i = 0, first = 0; i < keys.size(); ++i) {
        if (keys[i].first != keys[first].first) first = i;
        const Corner half_edge = keys[i].second;
        if (i != first && pairs.partner[half_edge] != keys[first].second) {
            found.push_back(half_edge);
        }
    }
    return found;
}

}  // namespace

Fans find_fans(const Polygons& polygons, const EdgePairs& pairs) {
    Fans fans;
    fans.vertex.assign(polygons.corner_count(), none);
    for (Corner corner = 0; corner < polygons.corner_count(); ++corner) {
        if (fans.vertex[corner] != none) continue;
        const auto vertex = static_cast<std::uint32_t>(fans.vertex_count());
        fans.point.push_back(polygons.point[corner]);
        spread(fans, corner, vertex, [&](Corner c) { return across_leaving(polygons, pairs, c); });
        spread(fans, across_entering(polygons, pairs, corner), vertex,
               [&](Corner c) { return across_entering(polygons, pairs, c); });
    }
    return fans;
}

Fans separate_double_edges(const Polygons& polygons, EdgePairs& pairs, Fans fans) {
    std::vector<Corner> lone;
    for (std::size_t edge = 0; edge < pairs.crowded.size(); ++edge) {
        const std::vector<Corner> more = doubles(polygons, pairs, fans, pairs.crowded[edge]);
        lone.insert(lone.end(), more.begin(), more.end());
    }
    if (lone.empty()) return fans;
    for (const Corner corner : lone) {
        pairs.part(corner);
        pairs.part(polygons.previous(corner));
        pairs.left_over[polygons.face_of[corner]] = true;
    }
    return find_fans(polygons, pairs);
}

}  // namespace scanlight::mesh
