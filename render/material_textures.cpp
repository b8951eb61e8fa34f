#include "render/material_textures.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

#include "mesh/mtl_words.h"
#include "render/image_channel.h"
#include "render/material_notes.h"
#include "render/materials.h"
#include "render/reflection_map.h"
#include "render/texture_image.h"

namespace scanlight::render {

namespace {

using mesh::MapUse;
using mesh::TextureMap;
using Maps = std::map<MapUse, TextureMap>;

using Textures = shading::SurfaceTextures;

/// Which texture a map becomes, and what its numbers are.
struct Slot {
    MapUse use;
    std::optional<shading::Texture> Textures::*texture;
    TexelMeaning meaning;
};

constexpr Slot slots[] = {{MapUse::ambient, &Textures::ambient, TexelMeaning::color},
                          {MapUse::diffuse, &Textures::diffuse, TexelMeaning::color},
                          {MapUse::specular, &Textures::specular, TexelMeaning::color},
                          {MapUse::emission, &Textures::emission, TexelMeaning::color},
                          {MapUse::exponent, &Textures::exponent, TexelMeaning::value},
                          {MapUse::opacity, &Textures::opacity, TexelMeaning::value},
                          {MapUse::bump, &Textures::bump, TexelMeaning::value},
                          {MapUse::normal, &Textures::normal, TexelMeaning::value}};

/// Null for what is not drawn.
const Slot* slot_of(MapUse use) {
    const auto* const slot = std::ranges::find(slots, use, &Slot::use);
    return slot == std::end(slots) ? nullptr : slot;
}

/// Those that change what is drawn. The constant colour of illum 0 is light of its own; a map_Ka
/// that says what map_Kd says would only be looked up twice.
Maps maps_drawn(const mesh::Material& material) {
    Maps maps = material.maps;
    const auto diffuse = maps.find(MapUse::diffuse);
    if (material.illumination == 0) {
        Maps constant;
        if (diffuse != maps.end()) constant[MapUse::emission] = diffuse->second;
        if (maps.contains(MapUse::opacity)) constant[MapUse::opacity] = maps.at(MapUse::opacity);
        return constant;
    }
    const auto ambient = maps.find(MapUse::ambient);
    const bool is_same =
        ambient != maps.end() && diffuse != maps.end() && ambient->second == diffuse->second;
    if (is_same) maps.erase(ambient);
    std::erase_if(maps, [](const auto& map) { return slot_of(map.first) == nullptr; });
    return maps;
}

ImageChannel channel_for(MapUse use, const TextureMap& map) {
    const bool is_number = use == MapUse::exponent || use == MapUse::opacity || use == MapUse::bump;
    if (!is_number) return ImageChannel::luminance;
    if (!map.channel) return use == MapUse::opacity ? ImageChannel::alpha : ImageChannel::luminance;
    switch (*map.channel) {
        case mesh::MapChannel::red:
            return ImageChannel::red;
        case mesh::MapChannel::green:
            return ImageChannel::green;
        case mesh::MapChannel::blue:
            return ImageChannel::blue;
        case mesh::MapChannel::matte:
            return ImageChannel::alpha;
        default:  // the pictures that are read have no depth
            return ImageChannel::luminance;
    }
}

shading::Wrap wrap_of(const TextureMap& map) {
    return map.clamped ? shading::Wrap::clamp : shading::Wrap::repeat;
}

WantedTexture wanted_for(MapUse use, const TextureMap& map) {
    WantedTexture wanted{map.path, slot_of(use)->meaning, channel_for(use, map)};
    if (use == MapUse::bump) wanted.slopes = wrap_of(map);
    return wanted;
}

/// Files are careless; beyond this no picture changes, and nothing may become infinite.
float bounded(float number) {
    return std::clamp(number, -1e6f, 1e6f);
}
glm::vec2 bounded(const glm::vec3& v) {
    return {bounded(v.x), bounded(v.y)};
}

shading::Texture texture_of(const TextureMap& map,
                            const std::shared_ptr<const shading::TexelImage>& image) {
    shading::Texture texture;
    texture.pattern = shading::Pattern::image;
    texture.image = image;
    texture.repeat = bounded(map.scale);
    texture.offset = bounded(map.offset);
    texture.low = glm::vec3(bounded(map.base));
    texture.high = texture.low + bounded(map.gain);
    texture.wrap = wrap_of(map);
    if (!map.blended_u && !map.blended_v) texture.filter = shading::Filter::nearest;
    return texture;
}

LoadedTextures load_all(const std::vector<mesh::Material>& materials, TextureLoader loader) {
    LoadedTextures textures;
    for (const mesh::Material& material : materials) {
        for (const auto& [use, map] : maps_drawn(material))
            textures[wanted_for(use, map)];
        for (const WantedTexture& side : sides_wanted(material))
            textures[side];
    }
    for (auto& [wanted, texture] : textures)
        texture = loader.loaded(wanted);
    return textures;
}

shading::SurfaceTextures textures_of(const mesh::Material& material, const LoadedTextures& all,
                                     double bump_unit, MaterialNotes& notes) {
    shading::SurfaceTextures textures;
    for (const auto& [use, map] : maps_drawn(material)) {
        const LoadedTexture& loaded = all.at(wanted_for(use, map));
        if (!loaded.image) {
            notes.add(material, mesh::statement_for(use) + " is left out: " + loaded.reason);
            continue;
        }
        textures.*(slot_of(use)->texture) = texture_of(map, loaded.image);
        if (use == MapUse::normal) textures.normal_scale = bounded(map.bump);
        if (use == MapUse::bump)
            textures.bump_height = bounded(map.bump) * static_cast<float>(bump_unit);
    }
    textures.mirrored = own_surroundings(material, all, notes);
    return textures;
}

}  // namespace

MaterialTextures surface_textures(const std::vector<mesh::Material>& materials,
                                  const LoadImage& load, double bump_unit, std::size_t most_bytes) {
    const LoadedTextures all = load_all(materials, {load, most_bytes});
    MaterialTextures result;
    MaterialNotes notes;
    for (const mesh::Material& material : materials)
        result.textures.push_back(textures_of(material, all, bump_unit, notes));
    if (std::ranges::none_of(result.textures, &shading::SurfaceTextures::any))
        result.textures.clear();
    result.warnings = notes.lines();
    return result;
}

std::vector<std::string> approximations(const std::vector<mesh::Material>& materials) {
    MaterialNotes notes;
    for (const mesh::Material& material : materials) {
        const std::string_view limits = approximation_of(material.illumination);
        if (!limits.empty()) {
            notes.add(material, "illum " + std::to_string(material.illumination) + ": " +
                                    std::string(limits));
        }
    }
    return notes.lines();
}

}  // namespace scanlight::render
