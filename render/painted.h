#pragma once

#include <glm/vec3.hpp>

#include "shading/material.h"

namespace scanlight::render {

/// A material under a vertex colour, which multiplies what has the body's own colour: ambient and
/// diffuse. The highlight stays.
inline shading::Material<float> painted(shading::Material<float> material, const glm::vec3& color) {
    material.ambient *= color;
    material.diffuse *= color;
    return material;
}

}  // namespace scanlight::render
