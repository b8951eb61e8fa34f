#include "apps/scene/material_options.h"

namespace scanlight::apps {

namespace {

/// The same for all that is one value.
template <class Lay>
void lay_values(MaterialOptions& below, const MaterialOptions& above, Lay lay) {
    lay(below.ambient, above.ambient);
    lay(below.diffuse, above.diffuse);
    lay(below.specular, above.specular);
    lay(below.exponent, above.exponent);
    lay(below.mirror, above.mirror);
    lay(below.refracted, above.refracted);
    lay(below.opacity, above.opacity);
    lay(below.filter, above.filter);
    lay(below.transmitted_diffuse, above.transmitted_diffuse);
    lay(below.transmitted_specular, above.transmitted_specular);
    lay(below.transmitted_exponent, above.transmitted_exponent);
}

}  // namespace

MaterialOptions laid_over(MaterialOptions below, const MaterialOptions& above) {
    if (above.diffuse || above.facets.is_metal()) below.ambient.reset();
    if (above.facets.is_metal()) below.diffuse.reset();
    lay_values(below, above, [](auto& to, const auto& from) {
        if (from) to = from;
    });
    below.facets = laid_over(below.facets, above.facets);
    below.textures = laid_over(below.textures, above.textures);
    return below;
}

shading::Material<float> with(shading::Material<float> base, const MaterialOptions& options) {
    shading::Material<float> material = with_facets(base, options.facets);
    const auto set = [](auto& to, const auto& from) {
        if (from) to = *from;
    };
    set(material.ambient, options.ambient ? options.ambient : options.diffuse);
    set(material.diffuse, options.diffuse);
    set(material.specular, options.specular);
    set(material.exponent, options.exponent);
    set(material.mirror, options.mirror);
    set(material.refracted, options.refracted);
    set(material.opacity, options.opacity);
    set(material.filter, options.filter);
    set(material.transmission.diffuse, options.transmitted_diffuse);
    set(material.transmission.specular, options.transmitted_specular);
    set(material.transmission.exponent, options.transmitted_exponent);
    return material;
}

}  // namespace scanlight::apps
