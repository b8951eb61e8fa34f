#pragma once

#include "raster/lanes/cull.h"
#include "raster/plane.h"

namespace scanlight::raster::HWY_NAMESPACE {

// The planes of raster/plane.h for as many triangles as there are lanes, by the same steps in the
// same order, so with the same bits.

/// `PlaneSetup`, and which lanes have one.
struct PlaneSetupLanes {
    Doubles x1, y1, x2, y2;
    Doubles inverse_area;
    Doubles offset_x, offset_y;
    Mask exists;
};

inline Doubles offset_to_centre(Ints c) {
    return doubles_of(Ints(half_pixel) - (c & Ints(subpixels - 1))) / Doubles(double{subpixels});
}

inline PlaneSetupLanes plane_setup(const Ints (&x)[3], const Ints (&y)[3]) {
    const Ints x1 = x[1] - x[0];
    const Ints y1 = y[1] - y[0];
    const Ints x2 = x[2] - x[0];
    const Ints y2 = y[2] - y[0];
    PlaneSetupLanes s;
    s.x1 = doubles_of(x1);
    s.y1 = doubles_of(y1);
    s.x2 = doubles_of(x2);
    s.y2 = doubles_of(y2);
    const Doubles area = s.x1 * s.y2 - s.x2 * s.y1;
    const Ints extent = max(max(abs(x1), abs(y1)), max(abs(x2), abs(y2)));
    s.exists = doubles_of(extent) < Doubles(thinnest) * abs(area);
    s.inverse_area = Doubles(double{subpixels}) / area;
    s.offset_x = offset_to_centre(x[0]);
    s.offset_y = offset_to_centre(y[0]);
    return s;
}

struct GradientLanes {
    Doubles dx, dy;
};

inline GradientLanes gradient(const PlaneSetupLanes& s, Doubles v0, Doubles v1, Doubles v2) {
    const Doubles d1 = v1 - v0;
    const Doubles d2 = v2 - v0;
    return {(d1 * s.y2 - d2 * s.y1) * s.inverse_area, (d2 * s.x1 - d1 * s.x2) * s.inverse_area};
}

inline Longs change_to_reference(const PlaneSetupLanes& s, const GradientLanes& g) {
    return nearest(g.dx * s.offset_x + g.dy * s.offset_y);
}

/// `DepthPlane`, and which lanes have one.
struct DepthPlaneLanes {
    Longs origin, dx, dy;
    Mask exists;
};

inline DepthPlaneLanes depth_plane(const PlaneSetupLanes& s, const Ints (&z)[3]) {
    const Doubles scale(double{1 << ramp_bits});
    const Doubles z0 = doubles_of(z[0]) * scale;
    const GradientLanes g = gradient(s, z0, doubles_of(z[1]) * scale, doubles_of(z[2]) * scale);
    const Doubles limit(depth_gradient_limit);
    return {nearest(z0) + change_to_reference(s, g), nearest(g.dx), nearest(g.dy),
            s.exists & (abs(g.dx) < limit) & (abs(g.dy) < limit)};
}

/// `AttributePlane`.
struct AttributePlaneLanes {
    Ints origin, dx, dy;
};

inline AttributePlaneLanes attribute_plane(const PlaneSetupLanes& s, Ints v0, Ints v1, Ints v2) {
    const GradientLanes g = gradient(s, doubles_of(v0), doubles_of(v1), doubles_of(v2));
    return {v0 + low_bits(change_to_reference(s, g)), low_bits(nearest(g.dx)),
            low_bits(nearest(g.dy))};
}

}  // namespace scanlight::raster::HWY_NAMESPACE
