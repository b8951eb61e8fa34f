#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "raster/vertex.h"

namespace scanlight::raster {

// What clipping leaves of a concave polygon may be several parts. They stay one polygon, joined by
// bridges along the plane that have no width: there and back. But corners are rounded later, one by
// one, and a bridge from A to D beside one from C to B would gape by up to 1/256 pixel, enough for
// a pixel in the gap between two parts. So each bridge goes over all the crossings between its
// ends, in their order along the plane: what is passed there and back is the same edges then, and
// cancels to the bit.

/// The component of position in which these vertices lie farthest apart.
template <int N>
int widest_axis(const std::vector<ClipVertex<N>>& polygon, const std::vector<std::size_t>& places) {
    int widest = 0;
    float width = -1.0f;
    for (int axis = 0; axis < 4; ++axis) {
        const auto [low, high] = std::ranges::minmax(
            places, {}, [&](std::size_t i) { return polygon[i].position[axis]; });
        const float reach = polygon[high].position[axis] - polygon[low].position[axis];
        if (reach <= width) continue;
        width = reach;
        widest = axis;
    }
    return widest;
}

/// `crossings` are the places of the points on the plane, in the order of the polygon.
template <int N>
std::vector<std::size_t> sorted_along_plane(const std::vector<ClipVertex<N>>& polygon,
                                            std::vector<std::size_t> crossings) {
    const int axis = widest_axis(polygon, crossings);
    std::ranges::sort(crossings, [&](std::size_t a, std::size_t b) {
        const float at_a = polygon[a].position[axis];
        const float at_b = polygon[b].position[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    return crossings;
}

/// Calls `visit(place)` for what lies between two places of `sorted`, on the way to the second.
template <class Visit>
void visit_between(const std::vector<std::size_t>& sorted, std::size_t from, std::size_t to,
                   Visit&& visit) {
    const auto begin = std::ranges::find(sorted, from);
    const auto end = std::ranges::find(sorted, to);
    const int step = begin < end ? 1 : -1;
    for (auto i = begin + step; i != end; i += step)
        visit(*i);
}

/// A clipped polygon with its bridges laid over all the crossings on their way. The crossings are
/// an exit and an entry in turn; a bridge leads from each exit to the entry that follows it.
/// Polygons that cross a plane more often than `most` times keep their bridges, lest they grow with
/// the square of that.
template <int N>
std::vector<ClipVertex<N>> with_joint_bridges(const std::vector<ClipVertex<N>>& polygon,
                                              const std::vector<std::size_t>& crossings) {
    constexpr std::size_t most = 256;
    if (crossings.size() > most) return polygon;
    const auto sorted = sorted_along_plane(polygon, crossings);
    std::vector<ClipVertex<N>> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        result.push_back(polygon[i]);
        const std::size_t next = i + 1 < polygon.size() ? i + 1 : 0;
        const bool is_bridge =
            std::ranges::binary_search(crossings, i) && std::ranges::binary_search(crossings, next);
        if (!is_bridge) continue;
        visit_between(sorted, i, next,
                      [&](std::size_t place) { result.push_back(polygon[place]); });
    }
    return result;
}

}  // namespace scanlight::raster
