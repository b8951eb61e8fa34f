#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "apps/scene/facets.h"
#include "apps/scene/stated.h"
#include "apps/scene/texture_option.h"
#include "shading/material.h"

namespace scanlight::apps {

/// What is said of a surface: any of it.
struct MaterialOptions {
    std::string name;
    std::optional<glm::vec3> ambient;
    std::optional<glm::vec3> diffuse;
    std::optional<glm::vec3> specular;
    std::optional<double> exponent;
    std::optional<glm::vec3> mirror;
    std::optional<glm::vec3> refracted;
    std::optional<float> opacity;
    std::optional<glm::vec3> filter;                // T_f
    std::optional<glm::vec3> transmitted_diffuse;   // K_dt
    std::optional<glm::vec3> transmitted_specular;  // K_t
    std::optional<double> transmitted_exponent;     // n_t
    FacetOptions facets;
    SlotNames textures;
    Stated stated;
};

/// What `above` says, and of the rest what `below` says.
MaterialOptions laid_over(MaterialOptions below, const MaterialOptions& above);

/// What the options say, over what `base` says. A diffuse colour alone is the ambient one too.
shading::Material<float> with(shading::Material<float> base, const MaterialOptions& options);

}  // namespace scanlight::apps
