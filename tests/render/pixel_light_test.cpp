#include "render/pixel_light.h"

#include <gtest/gtest.h>

#include <map>

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

TEST(PixelLight, TermsAddUpToThePicture) {
    const Stage stage;
    for (const auto model : all_models) {
        for (const Shadows shadows : {Shadows::none, Shadows::zfail, Shadows::map}) {
            Settings settings;
            settings.illumination = model;
            settings.shadows = shadows;
            const Drawing drawing = draw(stage.scene, settings, size);
            const PixelLights lights(stage.scene, settings, size);
            for_each_pixel(size, [&](int x, int y) {
                const auto pixel = lights.at(x, y);
                if (!pixel) return;
                const auto& color = drawing.framebuffer.color.at(x, y);
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(pixel->intensity[k], color[k], close_enough) << x << ' ' << y;
            });
        }
    }
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
