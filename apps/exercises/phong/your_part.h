#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

// Exercise 3: Phong's model (chapter 12.1.2; Phong 1975).
//
//     I = I_a K_a + I_p (K_d (N.L) + K_s (R.V)^n)
//
// N, L and V are unit vectors that point away from the surface: the normal, to the light, to the
// viewer. R is L mirrored in N: R = 2 N (N.L) - L. Where R.V is below 0, take 0 for it before it is
// raised to n. Where N.L is not above 0 the light is behind the surface: only I_a K_a is left.

namespace scanlight::exercises {

struct Surface {
    double K_a, K_d, K_s;  // of ambient light, diffuse, specular
    double n;              // exponent of the highlight
};

struct Light {
    double I_a;  // ambient
    double I_p;  // of the source
};

inline double intensity(const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V,
                        const Surface& surface, const Light& light) {
    // Your part. glm::dot(a, b) is a.b; std::pow is in <cmath>.
    (void)N, (void)L, (void)V, (void)surface, (void)light;
    return 0.0;
}

}  // namespace scanlight::exercises
