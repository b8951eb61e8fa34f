#include "render/reflection_map.h"

#include <algorithm>
#include <utility>

#include "mesh/mtl_words.h"
#include "render/cube_image.h"

namespace scanlight::render {

namespace {

using mesh::MapUse;

/// In the order of `EnvironmentLayout::cube`, seen by one who stands inside.
constexpr MapUse cube_sides_in_order[] = {MapUse::cube_right, MapUse::cube_left,
                                          MapUse::cube_top,   MapUse::cube_bottom,
                                          MapUse::cube_front, MapUse::cube_back};

bool has_map(const mesh::Material& material, MapUse use) {
    return material.maps.contains(use);
}

bool has_sides_of_a_cube(const mesh::Material& material) {
    return std::ranges::any_of(cube_sides_in_order,
                               [&](MapUse side) { return has_map(material, side); });
}

std::vector<WantedTexture> cube_wanted(const mesh::Material& material) {
    std::vector<WantedTexture> wanted;
    for (const MapUse side : cube_sides_in_order) {
        if (!has_map(material, side)) return {};
        wanted.push_back({material.maps.at(side).path, TexelMeaning::color, ImageChannel::luminance,
                          RowAtZero::highest});
    }
    return wanted;
}

shading::Environment bare_environment(std::size_t pictures) {
    using enum shading::EnvironmentLayout;
    if (pictures == 1) return {latitudes, {}, shading::latitudes_from_y_up};
    return {cube, {}, cube_from_world};
}

}  // namespace

bool has_reflection_map(const mesh::Material& material) {
    return has_map(material, MapUse::sphere) || has_sides_of_a_cube(material);
}

std::vector<WantedTexture> sides_wanted(const mesh::Material& material) {
    if (has_sides_of_a_cube(material)) return cube_wanted(material);
    if (!has_map(material, MapUse::sphere)) return {};
    return {{material.maps.at(MapUse::sphere).path, TexelMeaning::color, ImageChannel::luminance}};
}

std::shared_ptr<const shading::Environment> own_surroundings(const mesh::Material& material,
                                                             const LoadedTextures& all,
                                                             MaterialNotes& notes) {
    if (!has_reflection_map(material)) return nullptr;
    const auto wanted = sides_wanted(material);
    if (wanted.empty()) {
        notes.add(material, "refl is left out: not all six sides of the cube are named");
        return nullptr;
    }
    shading::Environment environment = bare_environment(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const LoadedTexture& side = all.at(wanted[i]);
        if (side.image == nullptr) {
            notes.add(material, "refl is left out: " + side.reason);
            return nullptr;
        }
        environment.images[i] = side.image;
    }
    return std::make_shared<const shading::Environment>(std::move(environment));
}

}  // namespace scanlight::render
