#pragma once

#include "shading/real.h"

namespace scanlight::shading {

/// How the light of a lamp weakens with the distance r.
enum class Falloff {
    constant,        // 1: not at all
    inverse,         // 1/r; Wylie, Romney, Evans & Erdahl 1967
    inverse_square,  // 1/r^2: what a real point light does, E = I cos / r^2
    inverse_plus_k,  // 1/(r + k): finite at the lamp, softer than physics far away
};

/// A fall-off with its constants, in world units.
template <class Number>
struct DistanceLaw {
    Falloff falloff = Falloff::constant;
    Number k = Number(1);             // of inverse_plus_k, >= 0
    Number r_min = Number(1) / 1024;  // > 0; r, or r + k, counts as no less than this
};

/// I(r)/I_p, the share of a lamp's intensity that the law leaves at distance r >= 0.
/// Finite even at r = 0, and never grows with r.
template <class Real, class Number>
Real share_at(const DistanceLaw<Number>& law, Real r) noexcept {
    const auto clamped = [r_min = Real(law.r_min)](Real distance) {
        return select(distance > r_min, distance, r_min);
    };
    switch (law.falloff) {
        case Falloff::inverse:
            return Real(1) / clamped(r);
        case Falloff::inverse_square:
            return Real(1) / (clamped(r) * clamped(r));
        case Falloff::inverse_plus_k:
            return Real(1) / clamped(r + Real(law.k));
        case Falloff::constant:
            break;
    }
    return Real(1);
}

}  // namespace scanlight::shading
