#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scanlight::shading {

/// What a cell of the eye answers to its own light and to that of two neighbours on either side,
/// which inhibit it. The weights sum to 1: even light is seen as it is.
inline constexpr std::array<double, 5> lateral_inhibition_weights{-0.1, -0.1, 1.4, -0.1, -0.1};

/// Simulates how the eye sees a line of intensities: lateral inhibition (Mach 1865; Ratliff 1965,
/// "Mach Bands"), a high-pass filter. Beside a step it undershoots on the dark side and overshoots
/// on the bright one: the Mach bands of flat and Gouraud shading. The ends are continued outwards.
/// Returns as many numbers as it is given; they may be negative.
template <class Real>
std::vector<Real> lateral_inhibition(std::span<const Real> profile) {
    std::vector<Real> seen;
    seen.reserve(profile.size());
    const auto last = static_cast<std::ptrdiff_t>(profile.size()) - 1;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        Real sum(0);
        for (std::ptrdiff_t k = -2; k <= 2; ++k) {
            const auto j = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + k, 0, last));
            sum = sum +
                  Real(lateral_inhibition_weights[static_cast<std::size_t>(k + 2)]) * profile[j];
        }
        seen.push_back(sum);
    }
    return seen;
}

}  // namespace scanlight::shading
