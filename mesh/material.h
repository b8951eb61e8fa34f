#pragma once

#include <array>
#include <string>

#include <glm/vec3.hpp>

namespace scanlight::mesh {

/// Surface parameters as a file states them (Wavefront MTL's statements, by their names there).
/// Colours are linear and unclamped, as written. `mesh` only carries them: what they mean is
/// `shading`'s affair.
struct Material {
    std::string name;
    glm::vec3 ambient{0.2f};   // Ka
    glm::vec3 diffuse{0.8f};   // Kd
    glm::vec3 specular{0.0f};  // Ks
    float exponent = 1.0f;     // Ns
    float opacity = 1.0f;      // d, or 1 - Tr
    float refraction = 1.0f;   // Ni
    int illumination = 2;      // illum, 0 to 10
};

}  // namespace scanlight::mesh
