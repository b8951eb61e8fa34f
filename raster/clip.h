#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "raster/bridges.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// The six planes of the view volume in clip space: -w <= x, y <= w and 0 <= z <= w.
enum class ClipPlane { left, right, bottom, top, near, far };

inline constexpr std::array clip_planes{ClipPlane::near,  ClipPlane::far,    ClipPlane::left,
                                        ClipPlane::right, ClipPlane::bottom, ClipPlane::top};

/// Signed distance to a plane, inside positive; not Euclidean, but zero at the same place.
inline float distance(const glm::vec4& p, ClipPlane plane) {
    switch (plane) {
        case ClipPlane::left:
            return p.w + p.x;
        case ClipPlane::right:
            return p.w - p.x;
        case ClipPlane::bottom:
            return p.w + p.y;
        case ClipPlane::top:
            return p.w - p.y;
        case ClipPlane::near:
            return p.z;
        case ClipPlane::far:
            return p.w - p.z;
    }
    return 0.0f;
}

/// Moves a point that is next to a plane onto it, so that what is clipped ends at the picture's
/// edge to the bit, however small w is.
inline void lay_onto(ClipPlane plane, glm::vec4& p) {
    switch (plane) {
        case ClipPlane::left:
            p.x = -p.w;
            return;
        case ClipPlane::right:
            p.x = p.w;
            return;
        case ClipPlane::bottom:
            p.y = -p.w;
            return;
        case ClipPlane::top:
            p.y = p.w;
            return;
        case ClipPlane::near:
            p.z = 0.0f;
            return;
        case ClipPlane::far:
            p.z = p.w;
            return;
    }
}

/// Where the edge from `inside` to `outside` meets the plane. Always computed from the inside, so
/// that the two polygons of a shared edge find the same bits and no crack opens between them.
template <int N>
ClipVertex<N> crossing(const ClipVertex<N>& inside, const ClipVertex<N>& outside, ClipPlane plane) {
    const float d_in = distance(inside.position, plane);
    const float t = d_in / (d_in - distance(outside.position, plane));
    ClipVertex<N> result;
    result.position = inside.position + t * (outside.position - inside.position);
    lay_onto(plane, result.position);
    for (std::size_t k = 0; k < N; ++k) {
        result.attributes[k] =
            inside.attributes[k] + t * (outside.attributes[k] - inside.attributes[k]);
    }
    return result;
}

/// Which part of a polygon to keep. Both have the same corners on the plane, to the bit.
enum class KeptSide { inside, outside };

/// One pass of Sutherland & Hodgman 1974, "Reentrant Polygon Clipping", CACM 17(1). The parts of a
/// concave polygon stay one, see raster/bridges.h.
template <int N>
std::vector<ClipVertex<N>> clip_against(const std::vector<ClipVertex<N>>& polygon, ClipPlane plane,
                                        KeptSide kept = KeptSide::inside) {
    std::vector<ClipVertex<N>> result;
    std::vector<std::size_t> crossings;  // their places in `result`
    result.reserve(polygon.size() + 2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& from = polygon[i];
        const auto& to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const bool from_inside = distance(from.position, plane) >= 0.0f;
        const bool to_inside = distance(to.position, plane) >= 0.0f;
        if (from_inside == (kept == KeptSide::inside)) result.push_back(from);
        if (from_inside == to_inside) continue;
        crossings.push_back(result.size());
        result.push_back(from_inside ? crossing(from, to, plane) : crossing(to, from, plane));
    }
    return crossings.size() > 2 ? with_joint_bridges(result, crossings) : result;
}

template <int N>
bool entirely_inside(const std::vector<ClipVertex<N>>& polygon, ClipPlane plane) {
    for (const auto& vertex : polygon) {
        if (!(distance(vertex.position, plane) >= 0.0f)) return false;
    }
    return true;
}

/// The part of a polygon inside the view volume: n-gon in, n-gon out, empty when all is outside.
/// Near and far come first: behind them w may be zero or negative.
template <int N>
std::vector<ClipVertex<N>> clip(std::vector<ClipVertex<N>> polygon,
                                std::span<const ClipPlane> planes = clip_planes) {
    for (const ClipPlane plane : planes) {
        if (!entirely_inside(polygon, plane)) polygon = clip_against(polygon, plane);
    }
    return polygon;
}

}  // namespace scanlight::raster
