#include "render/textured.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include <glm/matrix.hpp>

#include "render/gouraud.h"

namespace scanlight::render {

namespace {

PlacedTextures placed(const shading::SurfaceTextures& textures,
                      const glm::mat4& object_from_world) {
    const auto place = [&](const std::optional<shading::Texture>& t) {
        PlacedTextures::Slot slot;
        if (t) slot = {&*t, t->texture_from_object * object_from_world};
        return slot;
    };
    return {place(textures.ambient),  place(textures.diffuse), place(textures.specular),
            place(textures.exponent), place(textures.opacity), place(textures.emission),
            place(textures.bump),     place(textures.normal),  textures.bump_height,
            textures.normal_scale,    textures.mirrored.get()};
}

/// The largest magnitude. By their bits numbers are in the same order, and many are compared at
/// once.
float largest_finite(const std::vector<float>& values) {
    constexpr auto infinite = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
    std::int32_t largest = 0;
    for (const float value : values) {
        const std::int32_t bits = std::bit_cast<std::int32_t>(value) & 0x7fffffff;
        largest = std::max(largest, bits < infinite ? bits : 0);
    }
    return std::bit_cast<float>(largest);
}

}  // namespace

std::vector<PlacedTextures> placed_textures(const Object& object) {
    const glm::mat4 object_from_world(glm::inverse(object.world_from_object));
    std::vector<PlacedTextures> result;
    if (object.textures.empty()) result.resize(object.materials.size());
    for (const auto& textures : object.textures)
        result.push_back(placed(textures, object_from_world));
    return result;
}

shading::SiteNeeds site_needs(const Object& object) {
    shading::SiteNeeds all;
    for (const auto& textures : object.textures) {
        const shading::SiteNeeds needs = textures.needs();
        all.point |= needs.point;
        all.gradients |= needs.gradients;
        all.uv_steps |= needs.uv_steps;
        all.texels = glm::max(all.texels, needs.texels);
        all.steps |= needs.steps;
    }
    return all;
}

FaceMatrices face_matrices(const Object& object, const Frame& frame) {
    const glm::dmat4 object_from_world = glm::inverse(object.world_from_object);
    return {glm::mat4(object_from_world * glm::dmat4(frame.world_from_screen)),
            frame.world_from_screen, glm::mat3(glm::transpose(glm::dmat3(object_from_world)))};
}

float uv_unit_of(const mesh::Vertices& vertices) {
    return unit_for(std::max(largest_finite(vertices.u), largest_finite(vertices.v)));
}

raster::Rgba textured_pixel(const TexturedSurface<float>& surface,
                            const shading::Material<float>& material,
                            const PlacedTextures& textures, const Frame& frame,
                            const Settings& settings) {
    const auto all = [](std::size_t, const glm::vec3& term) { return term; };
    const Look<float> look = look_of(textures, surface);
    const glm::vec3 color = with_model(settings, [&](const auto& model) {
        return illuminate_textured(model, surface, look, material, textures, frame, all);
    });
    return raster::Rgba(color, opacity_on(material, textures, surface.site));
}

}  // namespace scanlight::render
