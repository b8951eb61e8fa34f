#pragma once

// Exercise 1: an edge on its way down the screen (chapter 12.1.3; Wylie, Romney, Evans & Erdahl
// 1967).
//
// The scanline algorithm meets each edge of a polygon once for every scanline it crosses, and never
// intersects anything: it knows where the edge crosses the centre line of its first scanline, and
// how far the crossing moves from one scanline to the next.
//
// Pixels are squares of side 1; y grows downwards; row j has its centre line at y = j + 1/2. A row
// belongs to the edge when its centre line lies at or below the edge's upper end, and above its
// lower end: so that edges that meet share no row, and leave none out.

namespace scanlight::exercises {

struct ActiveEdge {
    int y_begin;   // the first row that the edge crosses
    int y_end;     // one past the last
    double x;      // where it crosses the centre line of the current row, at first of y_begin
    double dx_dy;  // how far x moves from one row to the next
};

/// The edge from (x0, y0) down to (x1, y1), y0 < y1.
inline ActiveEdge active_edge(double x0, double y0, double x1, double y1) {
    // Your part. std::ceil from <cmath> may be of use.
    (void)x0, (void)y0, (void)x1, (void)y1;
    return {0, 0, 0.0, 0.0};
}

/// To the next row: one addition.
inline void step(ActiveEdge& edge) {
    // Your part.
    (void)edge;
}

}  // namespace scanlight::exercises
