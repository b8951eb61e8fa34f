#pragma once

#include <cmath>

namespace scanlight::exercises {

struct ActiveEdge {
    int y_begin;
    int y_end;
    double x;
    double dx_dy;
};

inline ActiveEdge active_edge(double x0, double y0, double x1, double y1) {
    const int begin = static_cast<int>(std::ceil(y0 - 0.5));
    const int end = static_cast<int>(std::ceil(y1 - 0.5));
    const double dx_dy = (x1 - x0) / (y1 - y0);
    return {begin, end, x0 + (begin + 0.5 - y0) * dx_dy, dx_dy};
}

inline void step(ActiveEdge& edge) {
    edge.x += edge.dx_dy;
}

}  // namespace scanlight::exercises
