#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "raster/clip.h"
#include "raster/project.h"

namespace scanlight::raster {

// Faces of closed surfaces that reach to infinity (shadow volumes) on their way to the screen. A
// closed surface stays closed, to the last pixel: where two faces meet, both get the same corners,
// so that at each pixel their windings add up to zero, but for what the near plane cuts open.

using BareClipPolygon = std::vector<ClipVertex<0>>;
using BareScreenPolygon = std::vector<ScreenVertex<0>>;

inline constexpr std::array side_planes{ClipPlane::left, ClipPlane::right, ClipPlane::bottom,
                                        ClipPlane::top};

/// How deep a face is beyond the far plane.
enum class Deep {
    reaches,  // depth goes on there, up to `deepest_ndc`: nothing is clipped
    splits,   // the face is cut in two; the part beyond is deeper than everything
    beyond,   // all of it is deeper than everything
};

/// Projected; depth goes on beyond the far plane.
inline BareScreenPolygon project_deep(const BareClipPolygon& polygon, const Viewport& viewport) {
    BareScreenPolygon result;
    for (const auto& vertex : polygon)
        result.push_back(snapped<0>(vertex.position, viewport, deepest_ndc));
    return result;
}

/// Projected, all of it at one depth.
inline BareScreenPolygon project_at(const BareClipPolygon& polygon, const Viewport& viewport,
                                    Depth z) {
    BareScreenPolygon result = project_deep(polygon, viewport);
    for (auto& vertex : result)
        vertex.z = z;
    return result;
}

/// Calls `visit` with what the screen shows of a face, in one part or two.
template <class Visit>
void clip_volume_face(const BareClipPolygon& face, Deep deep, const Viewport& viewport,
                      Visit&& visit) {
    constexpr std::array near{ClipPlane::near};
    const BareClipPolygon before = clip(face, near);
    if (deep == Deep::beyond)
        return visit(project_at(clip(before, side_planes), viewport, depth_beyond));
    if (deep == Deep::reaches || entirely_inside(before, ClipPlane::far))
        return visit(project_deep(clip(before, side_planes), viewport));
    const BareClipPolygon within = clip_against(before, ClipPlane::far);
    const BareClipPolygon beyond = clip_against(before, ClipPlane::far, KeptSide::outside);
    visit(project_deep(clip(within, side_planes), viewport));
    visit(project_at(clip(beyond, side_planes), viewport, depth_beyond));
}

/// Calls `visit` with the triangles of the fan about the first corner.
template <class Polygon, class Visit>
void for_each_triangle(const Polygon& polygon, Visit&& visit) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
        visit(Polygon{polygon[0], polygon[i - 1], polygon[i]});
}

/// The points at which the outline of a face goes through the near plane: out and in again in turn,
/// beginning with a way out.
inline BareClipPolygon near_crossings(const BareClipPolygon& face) {
    BareClipPolygon crossings;
    bool begins_outside = false;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const auto& from = face[i];
        const auto& to = face[i + 1 < face.size() ? i + 1 : 0];
        const bool from_inside = distance(from.position, ClipPlane::near) >= 0.0f;
        const bool to_inside = distance(to.position, ClipPlane::near) >= 0.0f;
        if (from_inside == to_inside) continue;
        if (crossings.empty()) begins_outside = to_inside;
        crossings.push_back(from_inside ? crossing(from, to, ClipPlane::near)
                                        : crossing(to, from, ClipPlane::near));
    }
    if (begins_outside) std::rotate(crossings.begin(), crossings.begin() + 1, crossings.end());
    return crossings;
}

/// Calls `visit` with triangles on the near plane, before everything, that close what it cuts open
/// of a surface, if this is done for all faces: each stands on an edge of the section, and all have
/// one apex. Where the eye is inside, they say so.
template <class Visit>
void near_section(const BareClipPolygon& face, const Viewport& viewport, Visit&& visit) {
    constexpr Depth before_all = -1;
    const ClipVertex<0> apex{glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), {}};
    const BareClipPolygon crossings = near_crossings(face);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const BareClipPolygon triangle{apex, crossings[i + 1], crossings[i]};
        visit(project_at(clip(triangle, side_planes), viewport, before_all));
    }
}

}  // namespace scanlight::raster
