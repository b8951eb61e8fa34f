#pragma once

#include <span>

#include "shading/exponent.h"

namespace scanlight::shading {

/// How the slopes of microfacets are distributed: see microfacets.h.
enum class FacetDistribution {
    beckmann,  // Beckmann & Spizzichino 1963
    gauss,     // Torrance & Sparrow 1967
    cosine,    // cos^n(alpha), Blinn 1977
};

/// By what constants a distribution, and the reflection from it, is multiplied.
enum class FacetConstant {
    normalised,  // the facets' areas seen from above sum to the surface's: energy is kept
    textbook,    // as printed: gauss and cosine by 1, beckmann without 1/pi; R_s by 1/pi
};

/// The root mean square m of slopes.
double rms_slope(std::span<const double> slopes) noexcept;

/// A distribution of microfacets' slopes with what `facet_density` needs to know of it, worked out
/// once per material rather than once per pixel.
/// Invariant: m() lies in [least, most]; the rest follows from it.
class FacetSlopes {
public:
    static constexpr double least = 0.01;
    static constexpr double most = 1;

    /// `m` is the root mean square of the slopes, 0.05 to 0.6 for most surfaces; whatever lies
    /// beyond the least and the most, and NaN, counts as these. cos^n takes n = 2/m^2 - 2, whose
    /// highlight is about as wide.
    FacetSlopes(FacetDistribution distribution, double m,
                FacetConstant constant = FacetConstant::normalised) noexcept;

    FacetDistribution distribution() const noexcept { return distribution_; }
    double m() const noexcept { return m_; }
    /// n of cos^n(alpha).
    const Exponent& exponent() const noexcept { return exponent_; }
    /// What the distribution is multiplied by.
    double constant() const noexcept { return constant_; }
    /// What D G rho / ((N.L)(N.V)) is multiplied by: 1/4, or the textbook's 1/pi.
    double reflection_constant() const noexcept { return reflection_constant_; }

private:
    FacetDistribution distribution_;
    double m_;
    Exponent exponent_;
    double constant_;
    double reflection_constant_;
};

}  // namespace scanlight::shading
