#include "render/pixel_light.h"

#include <gtest/gtest.h>

#include <memory>
#include <tuple>

#include "render/room.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{48, 36};
constexpr float close_enough = 2e-6f;

constexpr shading::Illumination all_models[] = {
    shading::Illumination::lambert, shading::Illumination::gouraud71,
    shading::Illumination::phong,   shading::Illumination::blinn,
    shading::Illumination::hall,    shading::Illumination::cook_torrance};

/// A torus that shadows itself, under two lights.
struct Stage {
    mesh::Mesh mesh = shape_mesh("torus:16,10");
    Scene scene = scene_of(mesh, {{30.0, 40.0}, size});

    Stage() {
        auto& material = scene.objects.front().materials.front();
        material.facets.share = 0.4;
        material.transmission.diffuse = glm::vec3(0.3f);
        scene.lighting.lights = {
            white_light({1.0f, 0.3f, 0.2f}),
            shading::point_light<float>({-2.0f, 1.0f, 0.5f}, {0.2f, 0.3f, 0.6f},
                                        {shading::Falloff::inverse, 1.0f})};
    }
};

/// That the terms of each pixel add up to the picture's.
void expect_sums(const Scene& scene, const Settings& settings) {
    const Drawing drawing = draw(scene, settings, size);
    const PixelLights lights(scene, settings, size);
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        if (!pixel) return;
        const auto& color = drawing.framebuffer.color.at(x, y);
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(pixel->intensity[k], color[k], close_enough) << x << ' ' << y;
    });
}

TEST(PixelLight, TermsAddUpToThePicture) {
    const Stage stage;
    for (const auto model : all_models) {
        for (const Shadows shadows : {Shadows::none, Shadows::zfail, Shadows::map}) {
            Settings settings;
            settings.illumination = model;
            settings.shadows = shadows;
            expect_sums(stage.scene, settings);
        }
    }
}

mesh::Mesh painted_torus() {
    mesh::PolygonSoup soup = mesh::shape("torus:16,10");
    for (const glm::vec3& p : soup.positions)
        soup.colors.push_back(0.5f + 0.4f * p);
    return mesh::build(soup).mesh;
}

shading::Texture texture_of(shading::Pattern pattern, shading::Mapping mapping) {
    shading::Texture texture;
    texture.pattern = pattern;
    texture.mapping = mapping;
    texture.low = {0.2f, 0.3f, 0.5f};
    return texture;
}

/// The same with colours, textures and surroundings.
struct DressedStage {
    mesh::Mesh mesh = painted_torus();
    Scene scene = scene_of(mesh, {{30.0, 40.0}, size});

    DressedStage() {
        using enum shading::Pattern;
        auto& object = scene.objects.front();
        object.materials.front().mirror = glm::vec3(0.2f);
        object.materials.front().facets.share = 0.4;
        shading::SurfaceTextures textures;
        textures.diffuse = texture_of(checker, shading::Mapping::uv);
        textures.specular = texture_of(marble, shading::Mapping::uv);
        textures.exponent = texture_of(gradient, shading::Mapping::planar);
        textures.bump = texture_of(waves, shading::Mapping::spherical);
        textures.bump_height = 0.05f;
        object.textures = {textures};
        scene.mirrored = scene.diffuse =
            std::make_shared<shading::Environment>(shading::Environment{
                shading::EnvironmentLayout::latitudes, {room(64)}, shading::latitudes_from_y_up});
        scene.lighting.lights = {white_light({1.0f, 0.3f, 0.2f})};
    }
};

TEST(PixelLight, TermsAddUpWithColoursTexturesAndSurroundings) {
    const DressedStage stage;
    for (const auto model : all_models) {
        Settings settings;
        settings.illumination = model;
        expect_sums(stage.scene, settings);
    }
}

TEST(PixelLight, TellsOfEachTexture) {
    const DressedStage stage;
    const PixelLights lights(stage.scene, {}, size);
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        if (!pixel) return;
        ASSERT_EQ(pixel->textures.size(), 4u);
        const auto& [diffuse, specular, exponent, bump] = std::tie(
            pixel->textures[0], pixel->textures[1], pixel->textures[2], pixel->textures[3]);
        ASSERT_STREQ(diffuse.slot, "diffuse");
        ASSERT_TRUE(diffuse.uv && exponent.uv && bump.uv);
        ASSERT_FALSE(specular.uv) << "marble fills space";
        ASSERT_TRUE(pixel->vertex_color);
        const glm::vec3 K_d = plastic().diffuse * *pixel->vertex_color * diffuse.color;
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(pixel->K_d[k], K_d[k], close_enough);
    });
}

TEST(PixelLight, AHighlightIsMadeOfItsFacetTerms) {
    const Stage stage;
    Settings settings;
    settings.illumination = shading::Illumination::cook_torrance;
    const auto& facets = stage.scene.objects.front().materials.front().facets;
    const PixelLights lights(stage.scene, settings, size);
    int seen = 0;
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        if (!pixel) return;
        for (const LightAtPixel& light : pixel->lights) {
            if (!light.facets) continue;
            const auto& [D, G, F] = *light.facets;
            const float NV = shading::dot(pixel->N, pixel->V);
            if (NV < 0.01f) continue;
            const double scale = shading::pi * facets.share * facets.slopes.reflection_constant();
            const float part = static_cast<float>(scale) * D * G / NV;
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(light.highlight[k], part * F[k] * light.intensity[k], 1e-5f);
            ++seen;
        }
    });
    EXPECT_GT(seen, 100);
    EXPECT_FALSE(PixelLights(stage.scene, {}, size).at(24, 8)->lights.front().facets);
}

TEST(PixelLight, IsThereWhereAPolygonIs) {
    const Stage stage;
    const Settings settings;
    const auto ids = draw_ids(stage.scene, settings, size);
    const PixelLights lights(stage.scene, settings, size);
    int seen = 0;
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        ASSERT_EQ(pixel.has_value(), ids.at(x, y) != 0);
        if (!pixel) return;
        ASSERT_EQ(pixel->polygon, ids.at(x, y));
        ++seen;
    });
    EXPECT_GT(seen, 200);
}

TEST(PixelLight, VectorsKeepTheLawOfReflection) {
    const Stage stage;
    const PixelLights lights(stage.scene, {}, size);
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        if (!pixel) return;
        for (const LightAtPixel& light : pixel->lights) {
            const float NL = shading::dot(pixel->N, light.L);
            ASSERT_NEAR(shading::dot(pixel->N, light.R), NL, 1e-5f);
            ASSERT_NEAR(shading::dot(light.L, light.H), shading::dot(pixel->V, light.H), 1e-5f);
        }
    });
}

TEST(PixelLight, ASurfaceInAVolumeHasNoLight) {
    const Stage stage;
    Settings settings;
    settings.shadows = Shadows::zfail;
    const PixelLights lights(stage.scene, settings, size);
    int in_shadow = 0;
    for_each_pixel(size, [&](int x, int y) {
        const auto pixel = lights.at(x, y);
        if (!pixel) return;
        for (const LightAtPixel& light : pixel->lights) {
            ASSERT_EQ(light.share, light.stencil == 0 ? 1.0f : 0.0f);
            in_shadow += light.stencil != 0;
        }
    });
    EXPECT_GT(in_shadow, 10);
}

}  // namespace
}  // namespace scanlight::render
