#include "render/materials.h"

namespace scanlight::render {

shading::Material<float> shading_material(const mesh::Material& material) {
    const bool has_highlight = material.illumination >= 2;
    shading::Material<float> result;
    result.ambient = material.ambient;
    result.diffuse = material.diffuse;
    result.specular = has_highlight ? material.specular : glm::vec3(0.0f);
    result.exponent = static_cast<double>(material.exponent);
    result.opacity = material.opacity;
    if (material.refraction > 1.0f)
        result.facets.reflectance = shading::dielectric(material.refraction);
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

}  // namespace scanlight::render
