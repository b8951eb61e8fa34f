#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace scanlight::exercises {

struct Surface {
    double K_a, K_d, K_s;
    double n;
};

struct Light {
    double I_a;
    double I_p;
};

inline double intensity(const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V,
                        const Surface& surface, const Light& light) {
    const double NL = glm::dot(N, L);
    const double ambient = light.I_a * surface.K_a;
    if (NL <= 0) return ambient;
    const double RV = std::max(0.0, glm::dot(2.0 * N * NL - L, V));
    return ambient + light.I_p * (surface.K_d * NL + surface.K_s * std::pow(RV, surface.n));
}

}  // namespace scanlight::exercises
