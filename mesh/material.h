#pragma once

#include <map>
#include <string>

#include <glm/vec3.hpp>

#include "mesh/texture_map.h"

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
    glm::vec3 emission{0.0f};  // Ke
    glm::vec3 filter{1.0f};    // Tf, what is left of light that passes through
    std::map<MapUse, TextureMap> maps{};

    bool operator==(const Material&) const = default;
};

}  // namespace scanlight::mesh
