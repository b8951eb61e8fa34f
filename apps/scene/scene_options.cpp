#include "apps/scene/scene_options.h"

#include <algorithm>

#include "apps/scene/usage_error.h"
#include "apps/scene/words.h"

namespace scanlight::apps {

Wireframe wireframe_of(const SceneOptions& options) {
    const std::string& word = options.wireframe_word;
    if (word.empty()) return Wireframe::none;
    if (word == "all") return Wireframe::all;
    if (word == "hidden") return Wireframe::hidden;
    if (word == "over") return Wireframe::over;
    throw UsageError("wireframe '" + word + "': expected all, hidden or over");
}

void check_shadows(const SceneOptions& options) {
    const render::Shadows method = options.settings.shadows;
    if (!options.shadow_map_option.empty() && method != render::Shadows::map)
        throw UsageError(options.shadow_map_option + " is for --shadows map");
    if (options.show == Show::stencil) volumes_for("--show stencil", options);
    if (options.show == Show::details && method != render::Shadows::polygons)
        throw UsageError("--show details is for --shadows polygons");
}

render::Shadows volumes_for(const std::string& what, const SceneOptions& options) {
    const render::Shadows method = options.settings.shadows;
    if (method == render::Shadows::none) return render::Shadows::zfail;
    if (render::counts_volumes(method)) return method;
    throw UsageError(what + " counts shadow volumes, of which --shadows " + word_of(method) +
                     " has none; zpass and zfail have");
}

void add_texture(SceneOptions& options, TextureSlot slot, TextureOption texture) {
    const auto is_taken = [&](const std::string& name) {
        return std::ranges::find(options.textures, name, &TextureOption::name) !=
               options.textures.end();
    };
    texture.name = word_of(slot);
    while (is_taken(texture.name))
        texture.name += "'";
    options.material.textures[slot] = texture.name;
    options.textures.push_back(std::move(texture));
}

std::vector<LightOption> lights_in(const SceneOptions& options) {
    const LightOption from_the_upper_left{LightFrame::camera, glm::dvec3(-0.7, 0.7, 1.0)};
    return options.lights.empty() ? std::vector{from_the_upper_left} : options.lights;
}

std::vector<shading::Illumination> models_in(const SceneOptions& options) {
    std::vector<shading::Illumination> models;
    for (const ObjectOptions& object : options.objects)
        models.push_back(object.own.illumination.value_or(options.settings.illumination));
    return models;
}

void check_size(const SceneOptions& options) {
    const int grid = options.settings.grid;
    if (std::max(options.size.width, options.size.height) * grid <= raster::max_size) return;
    throw UsageError("size " + std::to_string(options.size.width) + "x" +
                     std::to_string(options.size.height) + " with " + std::to_string(grid * grid) +
                     " samples a pixel: expected at most " +
                     std::to_string(raster::max_size / grid) + " pixels each way");
}

void look_from(SceneOptions& options, const render::ViewAngles& view) {
    options.view = view;
    options.camera_keys.clear();
    options.eye.reset();
    options.target.reset();
}

void set_field_of_view(SceneOptions& options, double fov_deg) {
    options.fov_deg = fov_deg;
    options.lens_mm = 0.0;
}

}  // namespace scanlight::apps
