#pragma once

#include <cmath>

#include "shading/cook_torrance.h"
#include "tests/shading/precision.h"

namespace scanlight::shading {

/// The unit vector at the angle `theta` from z, `phi` about it; in degrees.
template <class Real>
Vec3<Real> polar(double theta, double phi) {
    const double sine = std::sin(radians(theta));
    return Vec3<Real>(Vec3<double>(sine * std::cos(radians(phi)), sine * std::sin(radians(phi)),
                                   std::cos(radians(theta))));
}

/// The integral of f(direction) over the hemisphere about z, by the middles of rows by columns.
template <class Function>
double over_hemisphere(int rows, int columns, Function f) {
    double sum = 0;
    for (int i = 0; i < rows; ++i) {
        const double theta = 90.0 * (i + 0.5) / rows;
        double ring = 0;
        for (int j = 0; j < columns; ++j)
            ring += f(polar<double>(theta, 360.0 * (j + 0.5) / columns));
        sum += ring * std::sin(radians(theta));
    }
    return sum * radians(90.0 / rows) * radians(360.0 / columns);
}

/// The area of all facets as seen from above, of a unit of surface: the integral of D cos(alpha).
inline double projected_area(const FacetSlopes& slopes) {
    return over_hemisphere(20000, 1,
                           [&](const Vec3<double>& H) { return facet_density(H.z, slopes) * H.z; });
}

/// What of the light from V is sent back in all directions if each facet is a perfect mirror.
inline double albedo_of(const FacetSlopes& slopes, const Vec3<double>& V) {
    const Reflectance perfect = metal(Rgb<double>(1e-9), Rgb<double>(1));
    return over_hemisphere(240, 240, [&](const Vec3<double>& L) {
        return cook_torrance({0, 0, 1}, L, V, slopes, perfect).x;
    });
}

}  // namespace scanlight::shading
