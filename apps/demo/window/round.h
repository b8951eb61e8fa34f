#pragma once

#include <glm/vec3.hpp>

namespace scanlight::apps::window {

/// The nearest number whose last digit is as small as that of a number of this `size` with so many
/// digits: rounded(3.14159, 10.0, 3) is 3.1.
double rounded(double value, double size, int digits);

/// Each component.
glm::dvec3 rounded(const glm::dvec3& value, double size, int digits);

}  // namespace scanlight::apps::window
