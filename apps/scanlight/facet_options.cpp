#include "apps/scanlight/facet_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/scanlight/choice_option.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/text_option.h"
#include "apps/scene/parse.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

using Options = std::vector<CLI::Option*>;

Options add_slope_options(CLI::App& app, FacetOptions& o) {
    return {
        app.add_option("--roughness", o.roughness, "the facets' slope m, root mean square")
            ->type_name("M")
            ->check(within(shading::FacetSlopes::least, shading::FacetSlopes::most))
            ->default_str(CLI::detail::to_string(usual_roughness)),
        add_choice(app, "--distribution", o.distribution, usual_distribution,
                   "how the facets' slopes are distributed"),
        add_choice(app, "--constant", o.constant, usual_constant,
                   "so that energy is kept, or as printed in textbooks, four times too bright")};
}

CLI::Option* add_index_option(CLI::App& app, FacetOptions& o) {
    return add_text(app, "--ior", "N",
                    "index of refraction, the file's or 1.5 if not given; for hall, and for what\n"
                    "is seen by refract=, that of what lies behind the surface, 1 if not given",
                    [&o](const std::string& text) {
                        forget_reflectance(o);
                        o.ior = parse_number(text, "ior");
                    })
        ->check(within(0.1, 100.0));
}

Options add_metal_options(CLI::App& app, FacetOptions& o, CLI::Option* index) {
    CLI::Option* metal =
        add_text(app, "--metal", "NAME", "facets of " + metal_names() + ", as measured",
                 [&o](const std::string& text) {
                     forget_reflectance(o);
                     o.metal = &parse_metal(text);
                 })
            ->excludes(index);
    CLI::Option* reflectance =
        add_text(app, "--reflectance", "COLOUR",
                 "facets of a metal that mirrors this of the light, straight back",
                 [&o](const std::string& text) {
                     forget_reflectance(o);
                     o.reflectance = parse_color(text);
                 })
            ->excludes(index)
            ->excludes(metal);
    return {metal, reflectance};
}

Options add_share_options(CLI::App& app, FacetOptions& o) {
    return {add_choice(app, "--fresnel", o.form, FresnelForm::exact,
                       "an index for each channel, or (fast) one for all"),
            app.add_option("--specular-share", o.specular_share,
                           "K_s, what facets have of the light; the body has 1 - K_s. 0.5 if not\n"
                           "given, of metals 1")
                ->type_name("KS")
                ->check(within(0.0, 1.0))};
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

void require_model(const std::string& what, const IlluminationModels& chosen,
                   const IlluminationModels& models) {
    const auto is_known = [&](auto model) {
        return std::ranges::find(models, model) != models.end();
    };
    if (std::ranges::any_of(chosen, is_known)) return;
    std::string words;
    for (const auto model : models)
        words += (words.empty() ? "" : " or ") + word_of(model);
    throw UsageError(what + ": for --illumination " + words + " only");
}

}  // namespace scanlight::apps
