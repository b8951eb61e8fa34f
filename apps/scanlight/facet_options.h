#pragma once

#include <string>
#include <vector>

#include "apps/scene/facets.h"
#include "shading/illumination.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace scanlight::apps {

using IlluminationModels = std::vector<shading::Illumination>;

/// An option that means nothing to other models than these.
struct ModelOption {
    const CLI::Option* option;
    IlluminationModels models;
};

/// Adds the options that fill `options` as the command line is parsed.
std::vector<ModelOption> add_facet_options(CLI::App& app, FacetOptions& options);

/// Throws UsageError if none of the chosen models is one of those to which `what` means something.
void require_model(const std::string& what, const IlluminationModels& chosen,
                   const IlluminationModels& models);

}  // namespace scanlight::apps
