#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// Ambient light: a constant in place of all the light that surfaces send to each other; Bouknight
/// 1970 used it for what the light does not reach.
///     I_e = I_a K_a
template <class Real>
Rgb<Real> ambient(const Rgb<Real>& I_a, const Rgb<Real>& K_a) noexcept {
    return I_a * K_a;
}

}  // namespace scanlight::shading
