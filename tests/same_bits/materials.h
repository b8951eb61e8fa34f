#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "shading/material.h"

namespace scanlight::same_bits {

/// Materials that differ in all they have.
inline std::vector<shading::Material<float>> several_materials(std::size_t count) {
    constexpr int exponents[] = {20, 1, 300, 2000, 7};
    std::vector<shading::Material<float>> materials(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto part = static_cast<float>(i + 1) / static_cast<float>(count);
        materials[i].ambient = glm::vec3(part, 0.2f, 0.5f);
        materials[i].diffuse = glm::vec3(0.4f, 1.0f - part, part);
        materials[i].specular = glm::vec3(0.3f, 0.3f * part, 0.6f);
        materials[i].exponent = exponents[i % 5];
    }
    return materials;
}

}  // namespace scanlight::same_bits
