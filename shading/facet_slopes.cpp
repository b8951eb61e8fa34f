#include "shading/facet_slopes.h"

#include <algorithm>
#include <cmath>

#include "shading/microfacets.h"
#include "shading/radiometry.h"

namespace scanlight::shading {
namespace {

double in_range(double m) {
    return m > FacetSlopes::least ? std::min(m, FacetSlopes::most) : FacetSlopes::least;
}

/// The integral of f from 0 to `end` by Simpson's rule, in so many pairs of steps.
template <class Function>
double integral(double end, int pairs, Function f) {
    const double step = end / (2 * pairs);
    double sum = f(0.0) - f(end);
    for (int i = 1; i <= pairs; ++i)
        sum += 4 * f((2 * i - 1) * step) + 2 * f(2 * i * step);
    return sum * step / 3;
}

/// k such that k e^-(alpha/m)^2 cos(alpha) sums to 1 over the hemisphere. In x = 1 - cos(alpha),
/// dx = sin(alpha) d_alpha:
///     1/k = 2 pi (integral of e^-(alpha/m)^2 (1 - x) dx from 0 to 1)
/// Beyond x = 20 m^2 the bell is below e^-40.
double gauss_constant(double m) {
    const double sum = integral(std::min(1.0, 20 * m * m), 500, [m](double x) {
        return exp_of_minus(squared_angle(1 - x) / (m * m)) * (1 - x);
    });
    return 1 / (2 * pi * sum);
}

double normalising_constant(FacetDistribution distribution, double m, const Exponent& n) {
    switch (distribution) {
        case FacetDistribution::gauss:
            return gauss_constant(m);
        case FacetDistribution::cosine:
            return (n.value() + 2) / (2 * pi);
        case FacetDistribution::beckmann:
            break;
    }
    return 1 / pi;
}

}  // namespace

double rms_slope(std::span<const double> slopes) noexcept {
    if (slopes.empty()) return 0;
    double sum = 0;
    for (const double slope : slopes)
        sum += slope * slope;
    return std::sqrt(sum / static_cast<double>(slopes.size()));
}

FacetSlopes::FacetSlopes(FacetDistribution distribution, double m, FacetConstant constant) noexcept
    : distribution_(distribution),
      m_(in_range(m)),
      exponent_(2 / (m_ * m_) - 2),
      constant_(constant == FacetConstant::normalised
                    ? normalising_constant(distribution, m_, exponent_)
                    : 1.0),
      reflection_constant_(constant == FacetConstant::normalised ? 0.25 : 1 / pi) {}

}  // namespace scanlight::shading
