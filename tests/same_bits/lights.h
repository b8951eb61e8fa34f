#pragma once

#include <glm/vec3.hpp>

#include "shading/illumination.h"

namespace scanlight::same_bits {

using Light = shading::Light<float>;
using Law = shading::DistanceLaw<float>;

inline Light sun(const glm::vec3& towards, const glm::vec3& intensity = glm::vec3(0.9f)) {
    return shading::directional_light<float>(towards, intensity);
}

inline Light lamp(const glm::vec3& position, const glm::vec3& intensity, const Law& law = {}) {
    return shading::point_light<float>(position, intensity, law);
}

/// Different kinds and numbers of lights; `i` from 0 to before `lightings`.
inline constexpr int lightings = 5;
inline shading::Lighting<float> lighting(int i) {
    using shading::Falloff;
    const glm::vec3 ambient(0.1f, 0.12f, 0.15f);
    const Light left = sun({-0.5f, 0.7f, 1.0f});
    const Light right = sun({1.0f, 0.2f, 0.3f}, {0.5f, 0.4f, 0.1f});
    const Light near = lamp({0.5f, 1.5f, 2.0f}, {0.8f, 0.9f, 1.0f});
    const Light weak = lamp({-2.0f, 0.5f, 1.0f}, {2.0f, 1.0f, 0.5f}, {.falloff = Falloff::inverse});
    const Light bulb =
        lamp({0.0f, 2.0f, 0.5f}, {6.0f, 5.0f, 4.0f}, {.falloff = Falloff::inverse_square});
    const Light soft = lamp({2.0f, 0.0f, 1.5f}, {1.0f, 2.0f, 3.0f},
                            {.falloff = Falloff::inverse_plus_k, .k = 0.5f});
    switch (i) {
        case 0:
            return {ambient, {left}};
        case 1:
            return {ambient, {near}};
        case 2:
            return {glm::vec3(0.0f), {left, right, weak}};
        case 3:
            return {ambient, {bulb}};
        default:
            return {ambient, {soft, right}};
    }
}

}  // namespace scanlight::same_bits
