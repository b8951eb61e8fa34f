#include "render/material_textures.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "shading/luminance.h"

namespace scanlight::render {
namespace {

using mesh::MapUse;
using mesh::Material;
using mesh::TextureMap;

raster::Image8 picture(int width, int height, int channels) {
    raster::Image8 image(width, height, channels);
    std::uint8_t value = 0;
    for (std::uint8_t& sample : image.samples())
        sample = value = static_cast<std::uint8_t>(value + 40);
    return image;
}

/// Files by name, and how often each was asked for.
struct Files {
    std::map<std::string, raster::AnyImage> pictures;
    std::map<std::string, int> asked;

    LoadImage opener() {
        return [this](const std::string& path) {
            ++asked[path];
            const auto file = pictures.find(path);
            if (file == pictures.end()) throw std::runtime_error(path + ": no");
            return file->second;
        };
    }
};

TextureMap map_of(const std::string& path) {
    TextureMap map;
    map.path = path;
    return map;
}

Material material_of(const std::map<MapUse, TextureMap>& maps, const std::string& name = "m") {
    Material material;
    material.name = name;
    material.maps = maps;
    return material;
}

MaterialTextures textured(const std::vector<Material>& materials, Files& files) {
    return surface_textures(materials, files.opener(), 0.5);
}

glm::vec3 first_texel(const shading::Texture& texture) {
    return shading::texel_at<shading::TexelColor<float>, float>(*texture.image,
                                                                texture.image->index(0, 0));
}

TEST(MaterialTextures, EachStatementFindsItsAttribute) {
    Files files{{{"a", picture(2, 2, 3)}}, {}};
    using Textures = shading::SurfaceTextures;
    const std::pair<MapUse, std::optional<shading::Texture> Textures::*> slots[] = {
        {MapUse::ambient, &Textures::ambient},   {MapUse::diffuse, &Textures::diffuse},
        {MapUse::specular, &Textures::specular}, {MapUse::emission, &Textures::emission},
        {MapUse::exponent, &Textures::exponent}, {MapUse::opacity, &Textures::opacity},
        {MapUse::bump, &Textures::bump},         {MapUse::normal, &Textures::normal}};
    for (const auto& [use, slot] : slots) {
        const auto result = textured({material_of({{use, map_of("a")}})}, files);
        for (const auto& [other, texture] : slots)
            EXPECT_EQ((result.textures.at(0).*texture).has_value(), other == use);
    }
}

TEST(MaterialTextures, OptionsBecomeTheTexturesOwn) {
    Files files{{{"a", picture(3, 2, 3)}}, {}};
    TextureMap map = map_of("a");
    map.scale = {2, 3, 4};
    map.offset = {0.5f, -1, 0};
    map.base = 0.25f;
    map.gain = 2;
    map.clamped = true;
    map.blended_u = map.blended_v = false;
    map.bump = 3;
    const auto all =
        textured(
            {material_of({{MapUse::diffuse, map}, {MapUse::bump, map}, {MapUse::normal, map}})},
            files)
            .textures.at(0);
    const shading::Texture& texture = *all.diffuse;
    EXPECT_EQ(texture.repeat, glm::vec2(2, 3));
    EXPECT_EQ(texture.offset, glm::vec2(0.5f, -1));
    EXPECT_EQ(texture.low, glm::vec3(0.25f));
    EXPECT_EQ(texture.high, glm::vec3(2.25f));
    EXPECT_EQ(texture.wrap, shading::Wrap::clamp);
    EXPECT_EQ(texture.filter, shading::Filter::nearest);
    EXPECT_EQ(all.bump_height, 1.5f);
    EXPECT_EQ(all.normal_scale, 3.0f);
}

TEST(MaterialTextures, NoNumberOfAFileIsInfinite) {
    Files files{{{"a", picture(1, 1, 1)}}, {}};
    TextureMap map = map_of("a");
    map.scale = map.offset = glm::vec3(3e38f);
    map.base = map.gain = map.bump = 3e38f;
    const auto all = textured({material_of({{MapUse::bump, map}})}, files).textures.at(0);
    EXPECT_EQ(all.bump->high, glm::vec3(2e6f));
    EXPECT_EQ(all.bump->repeat, glm::vec2(1e6f));
    EXPECT_EQ(all.bump_height, 5e5f);
}

TEST(MaterialTextures, ColoursAreDecodedAndNumbersAreNot) {
    Files files{{{"a", picture(1, 1, 3)}}, {}};  // 40, 80, 120
    const auto all =
        textured({material_of({{MapUse::diffuse, map_of("a")}, {MapUse::normal, map_of("a")}})},
                 files)
            .textures.at(0);
    EXPECT_NEAR(first_texel(*all.diffuse).x, 0.0212f, 1e-4f);
    EXPECT_NEAR(first_texel(*all.normal).x, 40.0f / 255.0f, 1e-4f);
}

TEST(MaterialTextures, NumbersMayBeAnyChannel) {
    Files files{{{"rgba", picture(1, 1, 4)}, {"rgb", picture(1, 1, 3)}}, {}};  // 40, 80, 120, 160
    using mesh::MapChannel;
    const auto number = [&](MapUse use, const std::string& path,
                            std::optional<MapChannel> channel) {
        TextureMap map = map_of(path);
        map.channel = channel;
        const auto all = textured({material_of({{use, map}})}, files).textures.at(0);
        const auto& texture = use == MapUse::opacity ? all.opacity : all.exponent;
        return std::round(shading::luminance(first_texel(*texture)) * 255.0f);
    };
    const float luminance = std::round(0.2126f * 40 + 0.7152f * 80 + 0.0722f * 120);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::red), 40);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::green), 80);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::blue), 120);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::matte), 160);
    EXPECT_EQ(number(MapUse::exponent, "rgb", MapChannel::matte), luminance);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::luminance), luminance);
    EXPECT_EQ(number(MapUse::exponent, "rgba", MapChannel::depth), luminance);
    EXPECT_EQ(number(MapUse::exponent, "rgba", {}), luminance);
    EXPECT_EQ(number(MapUse::opacity, "rgba", {}), 160);
    EXPECT_EQ(number(MapUse::opacity, "rgb", {}), luminance);
    EXPECT_EQ(number(MapUse::opacity, "rgba", MapChannel::luminance), luminance);
}

TEST(MaterialTextures, EachFileIsLoadedOnce) {
    Files files{{{"a", picture(2, 2, 3)}, {"b", picture(2, 2, 3)}}, {}};
    std::vector<Material> materials;
    for (int i = 0; i < 5; ++i) {
        materials.push_back(material_of({{MapUse::diffuse, map_of("b")},
                                         {MapUse::specular, map_of("a")},
                                         {MapUse::bump, map_of(i % 2 ? "a" : "none")}}));
    }
    const auto result = textured(materials, files);
    EXPECT_EQ(files.asked, (std::map<std::string, int>{{"a", 1}, {"b", 1}, {"none", 1}}));
    EXPECT_EQ(result.textures[0].diffuse->image, result.textures[4].diffuse->image);
    EXPECT_NE(result.textures[1].specular->image, result.textures[1].bump->image);
}

TEST(MaterialTextures, AMissingFileIsAWarningAndTheRestIsDrawn) {
    Files files{{{"a", picture(2, 2, 3)}}, {}};
    const auto result = textured(
        {material_of({{MapUse::diffuse, map_of("a")}, {MapUse::bump, map_of("none")}}, "oak"),
         material_of({{MapUse::bump, map_of("none")}}, "elm")},
        files);
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"material \"oak\" and 1 more: bump is left out: none: no"});
    EXPECT_TRUE(result.textures.at(0).diffuse);
    EXPECT_FALSE(result.textures.at(0).bump);
}

TEST(MaterialTextures, WarningsHaveABound) {
    Files files;
    std::vector<Material> materials;
    for (int i = 0; i < 1000; ++i)
        materials.push_back(material_of({{MapUse::diffuse, map_of(std::to_string(i))}}));
    const auto result = textured(materials, files);
    EXPECT_EQ(result.warnings.size(), 20u);
    EXPECT_TRUE(result.textures.empty());
}

TEST(MaterialTextures, TogetherTheyHaveABound) {
    Files files{{{"a", picture(192, 192, 1)}, {"b", picture(192, 192, 1)}, {"c", picture(8, 8, 1)}},
                {}};
    const auto result = surface_textures(
        {material_of({{MapUse::diffuse, map_of("b")}}),
         material_of({{MapUse::diffuse, map_of("a")}, {MapUse::specular, map_of("c")}})},
        files.opener(), 1.0, std::size_t{1} << 20);
    EXPECT_EQ(result.warnings,
              std::vector<std::string>{"material \"m\": map_Kd is left out: b: the textures take "
                                       "more than 1 MiB together"});
    EXPECT_TRUE(result.textures.at(1).diffuse && result.textures.at(1).specular);
}

TEST(MaterialTextures, AmbientLikeDiffuseIsLookedUpOnce) {
    Files files{{{"a", picture(2, 2, 3)}, {"b", picture(2, 2, 3)}}, {}};
    const auto result =
        textured({material_of({{MapUse::diffuse, map_of("a")}, {MapUse::ambient, map_of("a")}}),
                  material_of({{MapUse::diffuse, map_of("a")}, {MapUse::ambient, map_of("b")}})},
                 files);
    EXPECT_FALSE(result.textures.at(0).ambient);
    EXPECT_TRUE(result.textures.at(1).ambient);
}

TEST(MaterialTextures, TheConstantColourOfIllumZeroIsTextured) {
    Files files{{{"a", picture(2, 2, 3)}}, {}};
    Material material =
        material_of({{MapUse::diffuse, map_of("a")}, {MapUse::specular, map_of("a")}});
    material.illumination = 0;
    const auto all = textured({material}, files).textures.at(0);
    EXPECT_TRUE(all.emission);
    EXPECT_FALSE(all.diffuse || all.specular);
}

TEST(MaterialTextures, WhatIsNotDrawnIsSaid) {
    std::vector<Material> materials{material_of({}, "glass"), material_of({}, "window")};
    materials[0].illumination = materials[1].illumination = 4;
    EXPECT_EQ(approximations(materials),
              (std::vector<std::string>{
                  "material \"glass\" and 1 more: illum 4: it mirrors surroundings, if there are "
                  "any, and does not refract"}));
}

}  // namespace
}  // namespace scanlight::render
