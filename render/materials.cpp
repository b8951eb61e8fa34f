#include "render/materials.h"

#include <algorithm>

#include "render/reflection_map.h"

namespace scanlight::render {

namespace {

/// The colour Kd as light of its own.
shading::Material<float> constant_color(const mesh::Material& material) {
    shading::Material<float> result;
    result.ambient = result.diffuse = result.specular = glm::vec3(0.0f);
    result.emission = material.diffuse;
    return result;
}

bool mirrors(const mesh::Material& material) {
    const int illum = material.illumination;
    return (illum >= 3 && illum <= 9) || has_reflection_map(material);
}

shading::Material<float> lit_material(const mesh::Material& material) {
    const bool has_highlight = material.illumination >= 2;
    shading::Material<float> result;
    result.ambient = material.ambient;
    result.diffuse = material.diffuse;
    result.specular = has_highlight ? material.specular : glm::vec3(0.0f);
    result.exponent = static_cast<double>(material.exponent);
    if (mirrors(material)) result.mirror = material.specular;
    if (material.refraction > 1.0f)
        result.facets.reflectance = shading::dielectric(material.refraction);
    result.emission = material.emission;
    return result;
}

}  // namespace

shading::Material<float> shading_material(const mesh::Material& material) {
    auto result = material.illumination == 0 ? constant_color(material) : lit_material(material);
    result.opacity = std::clamp(material.opacity, 0.0f, 1.0f);
    result.filter = material.filter;
    return result;
}

std::vector<shading::Material<float>> shading_materials(
    const std::vector<mesh::Material>& materials) {
    std::vector<shading::Material<float>> result;
    result.reserve(materials.size());
    for (const mesh::Material& material : materials)
        result.push_back(shading_material(material));
    return result;
}

std::string_view approximation_of(int illum) {
    switch (illum) {
        case 3:
        case 8:
            return "it mirrors surroundings, if there are any, and no other objects";
        case 5:
            return "it mirrors surroundings, if there are any, alike at every angle, and no other "
                   "objects";
        case 7:
            return "it mirrors surroundings, if there are any, alike at every angle, and does not "
                   "refract";
        case 4:
        case 6:
        case 9:
            return "it mirrors surroundings, if there are any, and does not refract";
        case 10:
            return "shadows on it are not seen alone";
        default:
            return {};
    }
}

}  // namespace scanlight::render
