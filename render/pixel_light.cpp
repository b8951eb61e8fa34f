#include "render/pixel_light.h"

#include <utility>

#include "render/draw.h"
#include "render/frame.h"
#include "render/lit_share.h"
#include "render/shadows.h"
#include "shading/blinn.h"
#include "shading/reflection.h"

namespace scanlight::render {

namespace {

using Material = shading::Material<float>;

/// The same without what is not the body's own light.
Material body_of(Material material) {
    material.specular = glm::vec3(0.0f);
    material.transmission = {};
    return material;
}

Material without_body(Material material) {
    material.diffuse = glm::vec3(0.0f);
    return material;
}

/// What a model adds for one light.
glm::vec3 term_of(const Settings& settings, const shading::Surface<float>& surface,
                  const Material& material, const shading::Incident<float>& light) {
    return with_model(settings, [&](const auto& model) { return model(surface, material, light); });
}

/// Cook and Torrance's body has the share that their facets leave.
glm::vec3 body_term(const Settings& settings, const shading::Surface<float>& surface,
                    const Material& material, const shading::Incident<float>& light) {
    if (settings.illumination != shading::Illumination::cook_torrance)
        return term_of(settings, surface, body_of(material), light);
    Material body = material;
    body.diffuse *= static_cast<float>(1.0 - material.facets.share);
    body.facets.share = 0.0;
    return term_of(settings, surface, body, light);
}

bool has_shadows(const Settings& settings) {
    return settings.shadows != Shadows::none;
}

}  // namespace

PixelLights::PixelLights(Scene scene, const Settings& settings, raster::Viewport viewport)
    : scene_(std::move(scene)),
      settings_(settings),
      viewport_(viewport),
      depth_(draw_depth(scene_, settings, viewport).framebuffer.depth),
      normals_(draw_normals(scene_, settings, viewport)),
      items_(draw_items(scene_, settings, viewport)),
      ids_(draw_ids(scene_, settings, viewport)),
      distances_(eye_distances(depth_, scene_.camera)) {
    for (std::size_t i = 0; i < scene_.lighting.lights.size(); ++i) {
        if (has_shadows(settings)) shares_.push_back(lit_share(scene_, settings, i, depth_));
        if (counts_volumes(settings.shadows))
            stencils_.push_back(count_shadows(scene_, settings, i, depth_));
    }
}

PixelLights::Place PixelLights::place_of(std::uint32_t item) const {
    std::size_t face = item;
    for (const Object& object : scene_.objects) {
        if (face < object.mesh->face_count()) return {&object, face};
        face -= object.mesh->face_count();
    }
    return {nullptr, 0};
}

std::optional<PixelLight> PixelLights::at(int x, int y) const {
    if (items_.at(x, y) == 0) return std::nullopt;
    const Frame frame = frame_of(scene_, settings_.distances, viewport_);
    PixelLight pixel{};
    pixel.item = items_.at(x, y) - 1;
    pixel.polygon = ids_.at(x, y);
    pixel.depth = depth_.at(x, y);
    pixel.distance = distances_.at(x, y);
    pixel.point = frame.point_at(x, y, pixel.depth);
    pixel.N = normals_.at(x, y);
    pixel.V = frame.view_from(pixel.point);

    const auto [object, face] = place_of(pixel.item);
    const Material& material = object->materials[object->mesh->face_material[face]];
    const Settings settings = settings_of(*object, settings_);
    pixel.K_a = material.ambient;
    pixel.K_d = material.diffuse;
    pixel.K_s = material.specular;
    pixel.exponent = material.exponent.value();
    pixel.ambient = shading::unlit<float>(material, frame.lighting);
    pixel.intensity = pixel.ambient;
    for (std::size_t i = 0; i < scene_.lighting.lights.size(); ++i) {
        pixel.lights.push_back(light_at(pixel, material, settings, i, x, y));
        const LightAtPixel& light = pixel.lights.back();
        pixel.intensity += (light.body + light.highlight) * light.share;
    }
    return pixel;
}

LightAtPixel PixelLights::light_at(const PixelLight& pixel, const Material& material,
                                   const Settings& settings, std::size_t index, int x,
                                   int y) const {
    const Frame frame = frame_of(scene_, settings_.distances, viewport_);
    const auto incident = shading::incident_at(frame.lighting.lights[index], pixel.point);
    const shading::Surface<float> surface{pixel.point, pixel.N, pixel.V};
    const glm::vec3& L = incident.direction;
    return {L,
            shading::half_vector(L, pixel.V),
            shading::reflected(L, pixel.N),
            incident.distance,
            incident.intensity,
            body_term(settings, surface, material, incident),
            term_of(settings, surface, without_body(material), incident),
            shares_.empty() ? 1.0f : shares_[index].at(x, y),
            stencils_.empty() ? 0 : stencils_[index].at(x, y)};
}

}  // namespace scanlight::render
