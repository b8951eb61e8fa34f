#include "apps/scene/facets.h"

namespace scanlight::apps {

namespace {

shading::Reflectance reflectance_of(const FacetOptions& options,
                                    const shading::Reflectance& of_file) {
    if (options.metal != nullptr) return shading::metal(options.metal->n, options.metal->k);
    if (options.reflectance) return shading::metal_of_color(*options.reflectance);
    return options.ior ? shading::dielectric(*options.ior) : of_file;
}

template <class Value>
void lay(std::optional<Value>& below, const std::optional<Value>& above) {
    if (above) below = above;
}

}  // namespace

void forget_reflectance(FacetOptions& options) {
    options.ior.reset();
    options.metal = nullptr;
    options.reflectance.reset();
}

FacetOptions laid_over(FacetOptions below, const FacetOptions& above) {
    if (above.ior || above.is_metal()) {
        below.ior = above.ior;
        below.metal = above.metal;
        below.reflectance = above.reflectance;
    }
    lay(below.roughness, above.roughness);
    lay(below.distribution, above.distribution);
    lay(below.constant, above.constant);
    lay(below.form, above.form);
    lay(below.specular_share, above.specular_share);
    return below;
}

shading::Material<float> with_facets(shading::Material<float> material,
                                     const FacetOptions& options) {
    const auto reflectance = reflectance_of(options, material.facets.reflectance);
    const bool is_fast = options.form == FresnelForm::fast;
    if (options.is_metal()) material.ambient = material.diffuse = glm::vec3(reflectance.C_0);
    material.facets = {
        {options.distribution.value_or(usual_distribution),
         options.roughness.value_or(usual_roughness), options.constant.value_or(usual_constant)},
        is_fast ? shading::shifted(reflectance) : reflectance,
        options.specular_share.value_or(options.is_metal() ? 1.0 : 0.5)};
    material.transmission.eta = options.ior.value_or(1.0);
    return material;
}

}  // namespace scanlight::apps
