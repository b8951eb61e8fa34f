#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "shading/material.h"

namespace scanlight::same_bits {

/// Facets of all distributions and all kinds of reflectance, as `i` goes from 0 to 8.
inline shading::Microfacets facets(std::size_t i) {
    using shading::FacetDistribution;
    constexpr FacetDistribution distributions[] = {
        FacetDistribution::beckmann, FacetDistribution::gauss, FacetDistribution::cosine};
    const shading::Reflectance materials[] = {
        shading::metal({0.21, 0.62, 1.38}, {3.272, 2.081, 1.914}), shading::dielectric(1.5),
        shading::shifted(shading::metal_of_color({0.95, 0.64, 0.35}))};
    const double part = static_cast<double>(i % 9 + 1) / 9;
    return {{distributions[i % 3], 0.05 + 0.6 * part}, materials[i / 3 % 3], part};
}

/// Thin, denser and less dense than what is before it.
inline shading::Transmission<float> transmission(std::size_t i) {
    constexpr double etas[] = {1.0, 1.5, 0.75};
    const auto part = static_cast<float>(i % 7 + 1) / 7;
    return {glm::vec3(part, 0.5f, 0.2f), glm::vec3(0.6f, part, 0.4f),
            static_cast<double>(3 * i + 5), etas[i % 3]};
}

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
        materials[i].transmission = transmission(i);
        materials[i].facets = facets(i);
    }
    return materials;
}

}  // namespace scanlight::same_bits
