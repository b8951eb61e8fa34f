#include "render/pixel_light.h"

#include <utility>

#include "render/draw.h"
#include "render/frame.h"
#include "render/lit_share.h"
#include "render/seen_surface.h"
#include "render/shadows.h"
#include "shading/blinn.h"
#include "shading/reflection.h"

namespace scanlight::render {

namespace {

/// The same without what is not the body's own light.
template <class Material>
Material body_of(Material material) {
    material.specular = glm::vec3(0.0f);
    material.transmission = {};
    return material;
}

template <class Material>
Material without_body(Material material) {
    material.diffuse = glm::vec3(0.0f);
    return material;
}

/// What a model adds for one light.
template <class Material>
glm::vec3 term_of(const Settings& settings, const shading::Surface<float>& surface,
                  const Material& material, const shading::Incident<float>& light) {
    return with_model(settings, [&](const auto& model) { return model(surface, material, light); });
}

/// Cook and Torrance's body has the share that their facets leave.
template <class Material>
glm::vec3 body_term(const Settings& settings, const shading::Surface<float>& surface,
                    const Material& material, const shading::Incident<float>& light) {
    if (settings.illumination != shading::Illumination::cook_torrance)
        return term_of(settings, surface, body_of(material), light);
    Material body = material;
    body.diffuse *= static_cast<float>(1.0 - material.facets.share);
    body.facets.share = 0.0;
    return term_of(settings, surface, body, light);
}

/// None where the model has no facets, or shows none.
template <class Material>
std::optional<FacetTerms> facets_at(const Settings& settings,
                                    const shading::Surface<float>& surface,
                                    const Material& material, const glm::vec3& L) {
    const auto& [point, N, V] = surface;
    const bool is_seen_lit = shading::dot(N, L) > 0.0f && shading::dot(N, V) > 0.0f;
    if (settings.illumination != shading::Illumination::cook_torrance || !is_seen_lit)
        return std::nullopt;
    const glm::vec3 H = shading::half_vector(L, V);
    const float NH = shading::dot(N, H);
    const float VH = shading::dot(V, H);
    return FacetTerms{
        shading::facet_density(NH, material.facets.slopes),
        shading::facets_open(NH, shading::dot(N, L), shading::dot(N, V), VH),
        shading::reflectance_at(VH, material.facets.reflectance),
    };
}

double value_of(const shading::Exponent& n) {
    return n.value();
}
double value_of(const shading::VaryingExponent<float>& n) {
    return n.value;
}

// ---- textures

TextureAtPixel texture_at(const char* slot, const shading::PlacedTexture& texture,
                          const shading::TextureSite<float>& site) {
    std::optional<glm::vec2> uv;
    if (!shading::fills_space(texture.texture->pattern)) {
        const auto place = shading::place_on(texture, site);
        uv = glm::vec2(place.u, place.v);
    }
    return {slot, uv, shading::color_at(texture, site)};
}

std::vector<TextureAtPixel> textures_at(const PlacedTextures& t,
                                        const shading::TextureSite<float>& site) {
    const std::pair<const char*, const PlacedTextures::Slot&> slots[] = {
        {"ambient", t.ambient},   {"diffuse", t.diffuse}, {"specular", t.specular},
        {"exponent", t.exponent}, {"opacity", t.opacity}, {"emission", t.emission},
        {"bump", t.bump},         {"normal", t.normal}};
    std::vector<TextureAtPixel> textures;
    for (const auto& [name, texture] : slots) {
        if (texture) textures.push_back(texture_at(name, *texture, site));
    }
    return textures;
}

/// Calls `use` with the material as colours and textures make it.
template <class Use>
void with_dressed(const shading::Material<float>& material, const PlacedTextures& textures,
                  const TexturedSurface<float>& surface, Use&& use) {
    const auto here = textured(material, textures, surface, look_of(textures, surface).paint);
    if (!textures.exponent) return use(here);
    use(with_exponent(here, shading::number_at(*textures.exponent, surface.site)));
}

void take_surface(PixelLight& pixel, const TexturedSurface<float>& seen,
                  const PlacedTextures& textures) {
    pixel.point = seen.surface.point;
    pixel.V = seen.surface.view;
    pixel.N = look_of(textures, seen).normal;
    pixel.textures = textures_at(textures, seen.site);
}

shading::Surface<float> lit_surface(const PixelLight& pixel) {
    return {pixel.point, pixel.N, pixel.V};
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
    PixelLight pixel{};
    pixel.item = items_.at(x, y) - 1;
    pixel.polygon = ids_.at(x, y);
    pixel.depth = depth_.at(x, y);
    pixel.distance = distances_.at(x, y);

    const Place place = place_of(pixel.item);
    const Object& object = *place.object;
    const std::size_t slot = object.mesh->face_material[place.face];
    const PlacedTextures textures = placed_textures(object)[slot];
    const Settings settings = settings_of(object, settings_);
    const Frame frame = frame_of(scene_, settings_.distances, viewport_);
    const auto seen = seen_surface(placed(object, frame), place.face, frame, settings, {x, y});
    take_surface(pixel, seen, textures);
    if (object.mesh->vertices.has_colors()) pixel.vertex_color = seen.color;
    const auto& material = object.materials[slot];
    with_dressed(material, textures, seen, [&](const auto& here) {
        pixel.ambient =
            unlit_textured(lit_surface(pixel), here, material, eta_seen(material, seen.outward),
                           frame, textures.mirrored ? textures.mirrored : frame.mirrored);
        light(pixel, here, settings, x, y);
    });
    return pixel;
}

/// Fills in what it knows of the material and of the lights.
template <class Material>
void PixelLights::light(PixelLight& pixel, const Material& material, const Settings& settings,
                        int x, int y) const {
    const Frame frame = frame_of(scene_, settings_.distances, viewport_);
    const shading::Surface<float> surface = lit_surface(pixel);
    pixel.K_a = material.ambient;
    pixel.K_d = material.diffuse;
    pixel.K_s = material.specular;
    pixel.exponent = value_of(material.exponent);
    pixel.intensity = pixel.ambient;
    for (std::size_t i = 0; i < scene_.lighting.lights.size(); ++i) {
        const auto incident = shading::incident_at(frame.lighting.lights[i], pixel.point);
        const glm::vec3& L = incident.direction;
        pixel.lights.push_back({L, shading::half_vector(L, pixel.V), shading::reflected(L, pixel.N),
                                incident.distance, incident.intensity,
                                body_term(settings, surface, material, incident),
                                term_of(settings, surface, without_body(material), incident),
                                shares_.empty() ? 1.0f : shares_[i].at(x, y),
                                stencils_.empty() ? 0 : stencils_[i].at(x, y),
                                facets_at(settings, surface, material, L)});
        const LightAtPixel& last = pixel.lights.back();
        pixel.intensity += (last.body + last.highlight) * last.share;
    }
}

}  // namespace scanlight::render
