#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// A point of a surface that is to be lit, in world space. A rasterized pixel, a vertex and a ray's
/// hit all become one.
template <class Real>
struct Surface {
    Vec3<Real> point;
    Vec3<Real> normal;  // N, unit, outward
    Vec3<Real> view;    // V, unit, towards the eye; the same everywhere for an eye at infinity
};

/// The same point of a surface without thickness, both sides of which are seen: the normal is
/// turned to the viewer's side, N.V >= 0. (Of a closed body the faces turned away are culled
/// instead.)
template <class Real>
Surface<Real> facing_viewer(const Surface<Real>& surface) noexcept {
    const auto turned_away = dot(surface.normal, surface.view) < Real(0);
    return {surface.point, select(turned_away, -surface.normal, surface.normal), surface.view};
}

}  // namespace scanlight::shading
