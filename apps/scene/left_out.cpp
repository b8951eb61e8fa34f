#include "apps/scene/left_out.h"

#include <algorithm>

#include "render/textured.h"

namespace scanlight::apps {

namespace {

bool knows_surroundings(const render::Scene& scene, const render::Object& object) {
    return scene.diffuse != nullptr ||
           (scene.mirrored != nullptr &&
            std::ranges::any_of(object.materials, render::shows_environment));
}

/// Of an object that is not Phong-shaded.
std::vector<std::string> left_by_vertices(const render::Scene& scene,
                                          const render::Object& object) {
    std::vector<std::string> sentences;
    if (std::ranges::any_of(object.textures, &shading::SurfaceTextures::any))
        sentences.push_back("the textures are left out: only Phong shading draws them");
    if (knows_surroundings(scene, object)) {
        sentences.push_back(
            "the surroundings are left out: only Phong shading mirrors or refracts them, or is "
            "lit by them");
    }
    return sentences;
}

std::vector<std::string> left_at_pixels(const render::Object& object) {
    const bool is_lost =
        std::ranges::any_of(object.textures, &shading::SurfaceTextures::needs_uv) &&
        !object.mesh->vertices.has_uvs();
    if (!is_lost) return {};
    return {
        "its textures are all of one place: the mesh has no texture coordinates; "
        "mapping=planar, cylindrical and spherical need none"};
}

}  // namespace

std::vector<std::string> left_out(const render::Scene& scene, const SceneOptions& options) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const render::Object& object = scene.objects[i];
        const bool is_phong =
            render::settings_of(object, options.settings).shading == render::Shading::phong;
        for (const auto& sentence :
             is_phong ? left_at_pixels(object) : left_by_vertices(scene, object))
            all.push_back(options.objects[i].input + ": " + sentence);
    }
    return all;
}

}  // namespace scanlight::apps
