#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/illumination.h"
#include "shading/metals.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace scanlight::apps {

/// Of colours that facets mirror: each channel by its own index, or all by one.
enum class FresnelForm { exact, fast };

/// What a surface is like to the models that know more of it than colours.
struct FacetOptions {
    double roughness = 0.2;  // m
    shading::FacetDistribution distribution = shading::FacetDistribution::beckmann;
    shading::FacetConstant constant = shading::FacetConstant::normalised;
    std::optional<double> ior;  // else the file's, and 1 behind what lets light through
    const shading::Metal* metal = nullptr;
    std::optional<glm::vec3> reflectance;  // of a metal, at 0 degrees
    FresnelForm form = FresnelForm::exact;
    std::optional<double> specular_share;  // K_s: 0.5, of a metal 1
};

using Models = std::vector<shading::Illumination>;

/// An option that means nothing to other models than these.
struct ModelOption {
    const CLI::Option* option;
    Models models;
};

/// Adds the options that fill `options` as the command line is parsed.
std::vector<ModelOption> add_facet_options(CLI::App& app, FacetOptions& options);

/// Throws UsageError if the chosen model is none of those to which `what` means something.
void require_model(const std::string& what, shading::Illumination chosen, const Models& models);

/// The material with the facets that the options say; a metal's body gets the metal's colour.
shading::Material<float> with_facets(shading::Material<float> material,
                                     const FacetOptions& options);

}  // namespace scanlight::apps
