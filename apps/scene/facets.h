#pragma once

#include <optional>

#include "shading/material.h"
#include "shading/metals.h"

namespace scanlight::apps {

/// Of colours that facets mirror: each channel by its own index, or all by one.
enum class FresnelForm { exact, fast };

/// What is said of a surface for the models that know more of it than colours: any of it.
struct FacetOptions {
    std::optional<double> roughness;  // m
    std::optional<shading::FacetDistribution> distribution;
    std::optional<shading::FacetConstant> constant;
    // One of these three says what facets mirror; else the file's index, and 1 behind what lets
    // light through.
    std::optional<double> ior;
    const shading::Metal* metal = nullptr;
    std::optional<glm::vec3> reflectance;  // of a metal, at 0 degrees
    std::optional<FresnelForm> form;
    std::optional<double> specular_share;  // K_s: 0.5, of a metal 1

    bool is_metal() const { return metal != nullptr || reflectance; }
};

/// What holds where nothing is said.
inline constexpr shading::FacetDistribution usual_distribution =
    shading::FacetDistribution::beckmann;
inline constexpr shading::FacetConstant usual_constant = shading::FacetConstant::normalised;
inline constexpr double usual_roughness = 0.2;

/// What facets mirror is to be said anew.
void forget_reflectance(FacetOptions& options);

/// What `above` says, and of the rest what `below` says.
FacetOptions laid_over(FacetOptions below, const FacetOptions& above);

/// The material with the facets that the options say; a metal's body gets the metal's colour.
shading::Material<float> with_facets(shading::Material<float> material,
                                     const FacetOptions& options);

}  // namespace scanlight::apps
