#pragma once

#include <limits>

#include "shading/falloff.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// A light source in world space. Make one with `directional_light` or `point_light`.
template <class Number>
struct Light {
    enum class Kind { directional, point };

    Kind kind;
    Vec3<Number> place;       // of a point light its position, of a directional one the unit
                              // vector towards it
    Rgb<Number> intensity;    // I_p
    DistanceLaw<Number> law;  // point lights only
};

/// A light at infinity: the same direction and intensity everywhere. `towards` points from the
/// scene to the light and may have any length; if it is zero there is no light.
/// With a `Surface::view` that is the same everywhere too, this is the literature's "light and eye
/// at infinity": L, V and H are constants of the picture, and intensity depends on N alone.
template <class Number>
Light<Number> directional_light(const Vec3<Number>& towards,
                                const Rgb<Number>& intensity) noexcept {
    const Vec3<Number> nowhere(Number(0));
    return {Light<Number>::Kind::directional, unit_or(towards, nowhere), intensity, {}};
}

/// A lamp at `position`; it keeps its intensity at any distance unless a law says otherwise.
template <class Number>
Light<Number> point_light(const Vec3<Number>& position, const Rgb<Number>& intensity,
                          const DistanceLaw<Number>& law = {}) noexcept {
    return {Light<Number>::Kind::point, position, intensity, law};
}

/// A light as one point sees it.
template <class Real>
struct Incident {
    Vec3<Real> direction;  // L, unit, towards the light; zero if the point is the light itself
    Rgb<Real> intensity;   // I_p after the fall-off
    Real distance;         // r; infinite for a directional light
};

/// A light at infinity has no distance for a fall-off to work on.
template <class Real, class Number>
Incident<Real> incident_from_infinity(const Light<Number>& light) noexcept {
    return {Vec3<Real>(light.place), Rgb<Real>(light.intensity),
            Real(std::numeric_limits<float>::infinity())};
}

template <class Real, class Number>
Incident<Real> incident_from_lamp(const Light<Number>& light, const Vec3<Real>& point) noexcept {
    const Vec3<Real> to_light = Vec3<Real>(light.place) - point;
    const Real r = square_root(dot(to_light, to_light));
    return {unit_or(to_light, Vec3<Real>(Real(0))),
            Rgb<Real>(light.intensity) * share_at(light.law, r), r};
}

/// The light that arrives at `point` (world space), if nothing stands between.
template <class Real, class Number>
Incident<Real> incident_at(const Light<Number>& light, const Vec3<Real>& point) noexcept {
    return light.kind == Light<Number>::Kind::directional ? incident_from_infinity<Real>(light)
                                                          : incident_from_lamp(light, point);
}

}  // namespace scanlight::shading
