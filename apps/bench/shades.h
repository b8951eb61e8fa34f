#pragma once

#include <array>
#include <cstddef>

#include "raster/fragments.h"
#include "raster/framebuffer.h"
#include "shading/illumination.h"

namespace scanlight::bench {

// What is left to do at a pixel after interpolation, and what the three corners of the triangle
// carry for it.

/// A constant colour: only depth is interpolated.
struct Flat {
    static constexpr int attribute_count = 0;
    static constexpr std::array<std::array<float, 0>, 3> corners{};

    raster::Rgba operator()(const raster::Fragment<0>&) const { return {0.75f, 0.5f, 0.25f, 1.0f}; }
};

/// Interpolated colour.
struct Gouraud {
    static constexpr int attribute_count = 3;
    static constexpr std::array<std::array<float, 3>, 3> corners{
        {{1.0f, 0.25f, 0.0f}, {0.0f, 1.0f, 0.5f}, {0.5f, 0.0f, 1.0f}}};

    raster::Rgba operator()(const raster::Fragment<3>& fragment) const {
        const auto& [r, g, b] = fragment.attributes;
        return {r, g, b, 1.0f};
    }
};

/// Interpolated normal, made unit and lit by one light with the chapter's model; light and eye at
/// infinity, exponent 32.
struct Phong {
    static constexpr int attribute_count = 3;
    static constexpr std::array<std::array<float, 3>, 3> corners{
        {{0.0f, 0.6f, 0.8f}, {-0.6f, 0.0f, 0.8f}, {0.48f, 0.36f, 0.8f}}};

    raster::Rgba operator()(const raster::Fragment<3>& fragment) const {
        const auto& [x, y, z] = fragment.attributes;
        const shading::Surface<float> surface{
            {}, shading::unit(glm::vec3(x, y, z)), {0.0f, 0.0f, 1.0f}};
        return {shading::illuminate<shading::Phong>(surface, material, lighting), 1.0f};
    }

    shading::Material<float> material{glm::vec3(0.1f), glm::vec3(0.6f), glm::vec3(0.3f), 32};
    shading::Lighting<float> lighting{
        glm::vec3(1.0f),
        {shading::directional_light(glm::vec3(0.3f, 0.6f, 1.0f), glm::vec3(1.0f))}};
};

}  // namespace scanlight::bench
