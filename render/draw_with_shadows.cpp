#include "render/draw_with_shadows.h"

#include <deque>
#include <utility>

#include "render/lit_share.h"

namespace scanlight::render {

namespace {

/// All objects bring their silhouettes, so that they are not made anew for each light; `own` holds
/// what is missing.
Scene with_silhouettes(Scene scene, std::deque<mesh::SilhouetteFinder>& own) {
    for (Object& object : scene.objects) {
        if (object.silhouettes == nullptr) object.silhouettes = &own.emplace_back(*object.mesh);
    }
    return scene;
}

void add_light(const Drawing& lit, const raster::Plane<float>& shares, Drawing& sum) {
    const raster::Viewport size = sum.framebuffer.size();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool is_drawn = lit.framebuffer.depth.at(x, y) < raster::depth_clear;
            const float share = shares.at(x, y);
            if (!is_drawn || share == 0.0f) continue;
            sum.framebuffer.color.at(x, y) +=
                raster::Rgba(share * glm::vec3(lit.framebuffer.color.at(x, y)), 0.0f);
        }
    }
}

/// It sends no light but what lights send it.
void darken(Object& object) {
    for (shading::Material<float>& material : object.materials)
        material.emission = glm::vec3(0.0f);
    for (shading::SurfaceTextures& textures : object.textures)
        textures.mirrored = nullptr;
}

}  // namespace

Scene lit_by(Scene scene, shading::Lighting<float> lighting) {
    scene.lighting = std::move(lighting);
    return scene;
}

Scene lit_by_one(const Scene& scene, std::size_t light) {
    Scene alone = lit_by(scene, {glm::vec3(0.0f), {scene.lighting.lights[light]}});
    alone.mirrored = alone.diffuse = alone.surroundings = nullptr;
    for (Object& object : alone.objects)
        darken(object);
    return alone;
}

Drawing draw_with_shadows(const Scene& bare, const Settings& settings, raster::Viewport viewport) {
    std::deque<mesh::SilhouetteFinder> own;
    const Scene scene = counts_volumes(settings.shadows) ? with_silhouettes(bare, own) : bare;
    Settings unshadowed = settings;
    unshadowed.shadows = Shadows::none;
    Drawing sum = draw_opaque(lit_by(scene, {scene.lighting.ambient, {}}), unshadowed, viewport);
    for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
        const auto shares = lit_share(scene, settings, i, sum.framebuffer.depth);
        add_light(draw_opaque(lit_by_one(scene, i), unshadowed, viewport), shares, sum);
    }
    return sum;
}

}  // namespace scanlight::render
