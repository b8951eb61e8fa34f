#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// Whitted 1980, "An improved illumination model for shaded display", CACM 23(6):
///     I = I_a K_a + sum of I_p [K_d (N.L)+ + K_s ((N.H)+)^n] + I_s K_s' + I_t K_t'
/// `local` is the light up to the sum, by `Blinn`. I_s and I_t are what arrives along S, the
/// mirrored view, and T, the refracted one; without rays the ambient light stands for both.
/// K_s' + K_t' <= 1.
template <class Real>
Rgb<Real> whitted(const Rgb<Real>& local, const Rgb<Real>& I_s, const Rgb<Real>& K_s,
                  const Rgb<Real>& I_t, const Rgb<Real>& K_t) noexcept {
    return local + (I_s * K_s + I_t * K_t);
}

/// The same at total internal reflection: what would be transmitted is reflected.
template <class Real>
Rgb<Real> whitted_at_total_reflection(const Rgb<Real>& local, const Rgb<Real>& I_s,
                                      const Rgb<Real>& K_s, const Rgb<Real>& K_t) noexcept {
    return local + I_s * (K_s + K_t);
}

}  // namespace scanlight::shading
