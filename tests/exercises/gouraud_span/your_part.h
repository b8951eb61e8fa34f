#pragma once

#include <cmath>

namespace scanlight::exercises {

struct Ramp {
    double I;
    double dI;
    int x_begin;
    int x_end;
};

inline Ramp ramp(double x_a, double I_a, double x_b, double I_b) {
    const double dI = (I_b - I_a) / (x_b - x_a);
    const int begin = static_cast<int>(std::ceil(x_a - 0.5));
    return {I_a + (begin + 0.5 - x_a) * dI, dI, begin, static_cast<int>(std::ceil(x_b - 0.5))};
}

inline void step(Ramp& ramp) {
    ramp.I += ramp.dI;
}

}  // namespace scanlight::exercises
