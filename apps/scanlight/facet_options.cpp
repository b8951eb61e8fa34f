#include "apps/scanlight/facet_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/scanlight/choice_option.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/parse.h"
#include "apps/scanlight/text_option.h"
#include "apps/scanlight/usage_error.h"

namespace scanlight::apps {

namespace {

using Options = std::vector<CLI::Option*>;

Options add_slope_options(CLI::App& app, FacetOptions& o) {
    return {
        app.add_option("--roughness", o.roughness, "the facets' slope m, root mean square")
            ->type_name("M")
            ->check(within(shading::FacetSlopes::least, shading::FacetSlopes::most))
            ->capture_default_str(),
        add_choice(app, "--distribution", o.distribution, "how the facets' slopes are distributed"),
        add_choice(app, "--constant", o.constant,
                   "so that energy is kept, or as printed in textbooks, four times too bright")};
}

CLI::Option* add_index_option(CLI::App& app, FacetOptions& o) {
    return app
        .add_option("--ior", o.ior,
                    "index of refraction, the file's or 1.5 if not given; for hall that of what\n"
                    "lies behind the surface, 1 if not given")
        ->type_name("N")
        ->check(within(0.1, 100.0));
}

Options add_metal_options(CLI::App& app, FacetOptions& o, CLI::Option* index) {
    CLI::Option* metal =
        add_text(app, "--metal", "NAME", "facets of " + metal_names() + ", as measured",
                 [&o](const std::string& text) { o.metal = &parse_metal(text); })
            ->excludes(index);
    CLI::Option* reflectance =
        add_text(app, "--reflectance", "COLOUR",
                 "facets of a metal that mirrors this of the light, straight back",
                 [&o](const std::string& text) { o.reflectance = parse_color(text); })
            ->excludes(index)
            ->excludes(metal);
    return {metal, reflectance};
}

Options add_share_options(CLI::App& app, FacetOptions& o) {
    return {
        add_choice(app, "--fresnel", o.form, "an index for each channel, or (fast) one for all"),
        app.add_option("--specular-share", o.specular_share,
                       "K_s, what facets have of the light; the body has 1 - K_s. 0.5 if not\n"
                       "given, of metals 1")
            ->type_name("KS")
            ->check(within(0.0, 1.0))};
}

shading::Reflectance reflectance_of(const FacetOptions& options,
                                    const shading::Reflectance& of_file) {
    if (options.metal != nullptr) return shading::metal(options.metal->n, options.metal->k);
    if (options.reflectance) return shading::metal_of_color(*options.reflectance);
    return options.ior ? shading::dielectric(*options.ior) : of_file;
}

}  // namespace

std::vector<ModelOption> add_facet_options(CLI::App& app, FacetOptions& options) {
    using enum shading::Illumination;
    const HelpHeading heading(app, "Microfacets (--illumination cook-torrance)");
    const Options slopes = add_slope_options(app, options);
    CLI::Option* index = add_index_option(app, options);
    const Options metals = add_metal_options(app, options, index);
    std::vector<ModelOption> result{{index, {cook_torrance, hall}}};
    for (const Options& more : {slopes, metals, add_share_options(app, options)}) {
        for (const CLI::Option* option : more)
            result.push_back({option, {cook_torrance}});
    }
    return result;
}

void require_model(const std::string& what, shading::Illumination chosen, const Models& models) {
    if (std::ranges::find(models, chosen) != models.end()) return;
    std::string words;
    for (const auto model : models)
        words += (words.empty() ? "" : " or ") + word_of(model);
    throw UsageError(what + ": for --illumination " + words + " only");
}

shading::Material<float> with_facets(shading::Material<float> material,
                                     const FacetOptions& options) {
    const bool is_metal = options.metal != nullptr || options.reflectance;
    const bool is_fast = options.form == FresnelForm::fast;
    const auto reflectance = reflectance_of(options, material.facets.reflectance);
    if (is_metal) material.ambient = material.diffuse = glm::vec3(reflectance.C_0);
    material.facets = {{options.distribution, options.roughness, options.constant},
                       is_fast ? shading::shifted(reflectance) : reflectance,
                       options.specular_share.value_or(is_metal ? 1.0 : 0.5)};
    material.transmission.eta = options.ior.value_or(1.0);
    return material;
}

}  // namespace scanlight::apps
