#pragma once

// Exercise 2: intensities along a span (chapter 12.1.3; Gouraud 1971).
//
// Between two edges of a polygon the intensity is interpolated, not by a formula at each pixel but
// by one addition from pixel to pixel.

namespace scanlight::exercises {

struct Ramp {
    double I;     // at the centre of the span's first pixel
    double dI;    // from one pixel to the next
    int x_begin;  // the first pixel of the span
    int x_end;    // one past the last
};

/// The span from the left edge, at x_a with intensity I_a, to the right one, at x_b with I_b;
/// x_a < x_b. A pixel i belongs to it when its centre, i + 1/2, is at or right of x_a, and left of
/// x_b.
inline Ramp ramp(double x_a, double I_a, double x_b, double I_b) {
    // Your part.
    (void)x_a, (void)I_a, (void)x_b, (void)I_b;
    return {0.0, 0.0, 0, 0};
}

/// To the next pixel.
inline void step(Ramp& ramp) {
    // Your part.
    (void)ramp;
}

}  // namespace scanlight::exercises
