#pragma once

namespace scanlight::mesh {

inline constexpr double pi = 3.14159265358979323846;

/// Sine, cosine and tangent, in radians, of + - x / only, so that a shape or a camera has the same
/// bits on every system; libm's differ. |x| up to 1e6; error below 1e-15 absolute (tan: relative,
/// away from its poles).
double sine(double x);
double cosine(double x);
double tangent(double x);

/// The angle of the point (x, y) about the origin, counter-clockwise from the x axis, in [0, 2 pi];
/// of + - x / and square roots only. Error below 1e-15 relative to pi. The origin has angle 0.
double angle_of(double y, double x);

}  // namespace scanlight::mesh
