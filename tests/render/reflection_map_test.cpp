#include "render/reflection_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "render/material_textures.h"

namespace scanlight::render {
namespace {

using mesh::MapUse;
using mesh::Material;

/// A picture whose upper half has the grey that is its name, and whose lower half is black.
raster::AnyImage half_grey(const std::string& name) {
    raster::ImageF image(4, 4, 1);
    for (int x = 0; x < 4; ++x)
        image.pixel(x, 0)[0] = image.pixel(x, 1)[0] = std::stof(name);
    return image;
}

Material material_with(const std::vector<std::pair<MapUse, std::string>>& maps) {
    Material material;
    material.name = "chrome";
    for (const auto& [use, path] : maps)
        material.maps[use].path = path;
    return material;
}

MaterialTextures textured(const Material& material) {
    const auto load = [](const std::string& path) {
        if (path == "missing") throw std::runtime_error("missing: there is no such file");
        return half_grey(path);
    };
    return surface_textures({material}, load, 1.0);
}

std::vector<std::pair<MapUse, std::string>> six_sides() {
    return {{MapUse::cube_right, "1"},  {MapUse::cube_left, "2"},  {MapUse::cube_top, "3"},
            {MapUse::cube_bottom, "4"}, {MapUse::cube_front, "5"}, {MapUse::cube_back, "6"}};
}

float seen(const MaterialTextures& result, const glm::vec3& direction) {
    const glm::vec3 unit = direction / std::sqrt(glm::dot(direction, direction));
    return shading::light_from(*result.textures.at(0).mirrored, unit).x;
}

TEST(ReflectionMap, OfASphereHasItsUpperRowsAbove) {
    const auto result = textured(material_with({{MapUse::sphere, "0.5"}}));
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_EQ(seen(result, {0.1f, 1.0f, 0.1f}), 0.5f);
    EXPECT_EQ(seen(result, {0.1f, -1.0f, 0.1f}), 0.0f);
}

TEST(ReflectionMap, OfACubeHasEachSideUprightInItsPlace) {
    const auto result = textured(material_with(six_sides()));
    EXPECT_TRUE(result.warnings.empty());
    const glm::vec3 sides[] = {{1, 0.6f, 0}, {-1, 0.6f, 0}, {0, 0.6f, -1}, {0, 0.6f, 1}};
    const float greys[] = {1, 2, 5, 6};
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(seen(result, sides[i]), greys[i]) << i;
        EXPECT_EQ(seen(result, sides[i] - glm::vec3(0, 1.2f, 0)), 0.0f) << i;
    }
    EXPECT_EQ(seen(result, {0, 1, 0.6f}), 3.0f);
    EXPECT_EQ(seen(result, {0, -1, -0.6f}), 4.0f);
}

TEST(ReflectionMap, ACubeComesBeforeASphere) {
    auto maps = six_sides();
    maps.emplace_back(MapUse::sphere, "missing");
    const auto result = textured(material_with(maps));
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_EQ(result.textures.at(0).mirrored->layout, shading::EnvironmentLayout::cube);
}

TEST(ReflectionMap, WithoutOneSideIsLeftOut) {
    auto maps = six_sides();
    maps.pop_back();
    const auto result = textured(material_with(maps));
    EXPECT_TRUE(result.textures.empty());
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"material \"chrome\": refl is left out: not all six sides "
                                       "of the cube are named"});
}

TEST(ReflectionMap, WithAMissingFileIsLeftOutOnce) {
    auto maps = six_sides();
    maps[1].second = maps[3].second = "missing";
    const auto result = textured(material_with(maps));
    EXPECT_TRUE(result.textures.empty());
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"material \"chrome\": refl is left out: missing: there is "
                                       "no such file"});
}

}  // namespace
}  // namespace scanlight::render
