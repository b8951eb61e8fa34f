#pragma once

#include "shading/cook_torrance.h"
#include "shading/exponent.h"
#include "shading/transmission.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// How a surface answers light. Each K is linear, channel by channel, and usually within 0 to 1.
/// All models know the first two; the others are of those that are named. `Power` is `Exponent`, or
/// `VaryingExponent` where each lane has its own.
template <class Number, class Power = Exponent>
struct Material {
    Rgb<Number> ambient{Number(0.2)};  // K_a
    Rgb<Number> diffuse{Number(0.8)};  // K_d
    Rgb<Number> specular{Number(0)};   // Phong, Blinn, Hall: K_s
    Power exponent{1};  // of that: n, usually 1 to 2000, the larger the smaller the highlight
    Transmission<Number> transmission{};  // Hall
    Microfacets facets{};                 // Cook & Torrance, for whom K_d of the above is rho_d
    float opacity = 1;                    // 1 - t: 0 lets all light through, 1 none
    Rgb<Number> mirror{Number(0)};        // K_s', of the environment mirrored
    Rgb<Number> refracted{Number(0)};     // K_t', of the same seen through it, bent by eta
    Rgb<Number> emission{Number(0)};      // light of its own, towards every side
    Rgb<float> filter{1.0f};  // what is left of light that comes through, where it is not opaque
};

}  // namespace scanlight::shading
