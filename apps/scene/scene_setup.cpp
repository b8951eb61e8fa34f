#include "apps/scene/scene_setup.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "apps/scene/placement.h"
#include "apps/scene/scene_image.h"
#include "apps/scene/stated.h"
#include "apps/scene/usage_error.h"
#include "apps/scene/words.h"
#include "mesh/bounds.h"
#include "render/cube_image.h"
#include "render/cube_map.h"
#include "render/framing.h"
#include "render/materials.h"
#include "render/room.h"
#include "render/texture_image.h"

namespace scanlight::apps {

namespace {

constexpr double lens_frame_height_mm = 24.0;

/// What a mesh without materials of its own is made of: clay with a soft highlight.
shading::Material<float> clay() {
    const glm::vec3 color(0.56f, 0.23f, 0.11f);
    return {color, color, glm::vec3(0.4f), 40.0};
}

shading::Material<float> white() {
    return {glm::vec3(0.8f), glm::vec3(0.8f), glm::vec3(0.0f), 1.0};
}

/// Under a texture that brings the colour.
shading::Material<float> colorless_clay() {
    shading::Material<float> material = clay();
    material.ambient = material.diffuse = glm::vec3(1.0f);
    return material;
}

bool has_own_materials(const mesh::Mesh& mesh) {
    return mesh.materials.size() > 1 || !mesh.materials.front().name.empty();
}

/// Those of the scene's that an object names; nothing if it names none.
MaterialOptions named_material(const ObjectOptions& object, const SceneOptions& options) {
    const auto found =
        std::ranges::find(options.materials, object.material, &MaterialOptions::name);
    return object.material.empty() || found == options.materials.end() ? MaterialOptions{} : *found;
}

/// All that is said of an object's surface.
MaterialOptions surface_of(const ObjectOptions& object, const SceneOptions& options) {
    MaterialOptions surface = named_material(object, options);
    surface.textures = laid_over(surface.textures, object.textures);
    return laid_over(surface, options.material);
}

/// Whether a texture brings an object's colour.
bool is_coloured(const ObjectOptions& object, const MaterialOptions& surface,
                 const SceneOptions& options) {
    const auto shading = object.own.shading.value_or(options.settings.shading);
    return shading == render::Shading::phong && !surface.textures[TextureSlot::diffuse].empty();
}

std::vector<shading::Material<float>> materials_of(const mesh::Mesh& mesh,
                                                   const MaterialOptions& surface,
                                                   bool is_coloured) {
    auto materials = render::shading_materials(mesh.materials);
    if (!has_own_materials(mesh)) materials.front() = is_coloured ? colorless_clay() : clay();
    for (auto& material : materials)
        material = with(material, surface);
    return materials;
}

const TextureOption& texture_named(const std::string& name, const SceneOptions& options) {
    const auto found = std::ranges::find(options.textures, name, &TextureOption::name);
    assert(found != options.textures.end());  // else the file was refused
    return *found;
}

shading::SurfaceTextures textures_named(const SlotNames& names, const mesh::Box& bounds,
                                        const SceneOptions& options, TextureImages& images) {
    shading::SurfaceTextures textures;
    for (const auto& [word, slot] : words_beside(TextureSlot{})) {
        if (!names[slot].empty())
            put(texture_named(names[slot], options), slot, bounds, images, textures);
    }
    return textures;
}

/// The mesh's own, and over them those that the surface names.
std::vector<shading::SurfaceTextures> textures_on(const Model& model, const SlotNames& names,
                                                  const SceneOptions& options,
                                                  TextureImages& images) {
    std::vector<shading::SurfaceTextures> textures = model.textures;
    const auto named = textures_named(names, mesh::bounding_box(model.mesh), options, images);
    if (!named.any()) return textures;
    textures.resize(model.mesh.materials.size());
    for (auto& own : textures)
        own = laid_over(own, named);
    return textures;
}

std::vector<render::Object> objects_of(const Models& models, const SceneOptions& options) {
    std::vector<render::Object> objects;
    TextureImages images;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const ObjectOptions& object = options.objects[i];
        const Model& model = *models.of_object[i];
        const MaterialOptions surface = surface_of(object, options);
        const bool has_color = is_coloured(object, surface, options);
        objects.push_back({&model.mesh, materials_of(model.mesh, surface, has_color),
                           matrix_of(object.placement), nullptr,
                           textures_on(model, surface.textures, options, images), object.own});
    }
    return objects;
}

double magnification(const SceneOptions& options) {
    return options.lens_mm > 0.0
               ? render::magnification_from_lens(options.lens_mm, lens_frame_height_mm)
               : render::magnification_from_fov(options.fov_deg);
}

double distance(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 line = a - b;
    return std::sqrt(glm::dot(line, line));
}

/// At `eye`, which the options give.
render::Camera placed_camera(render::Camera camera, const glm::dvec3& eye,
                             const std::vector<render::Object>& objects, const glm::dvec3& target) {
    camera.eye = eye;
    camera.target = target;
    if (camera.projection == render::Projection::orthographic) {
        // What the field of view would show at the target.
        camera.magnification /= std::max(distance(camera.eye, camera.target), 1e-30);
    }
    return render::with_fitted_planes(camera, objects);
}

/// On the side that the options name, as far away as shows all.
render::Camera framing_camera(render::Camera camera, const std::vector<render::Object>& objects,
                              const SceneOptions& options) {
    camera.target = glm::dvec3(0.0);
    camera.eye = render::direction_of(options.view);
    return render::framed(camera, objects,
                          static_cast<double>(options.size.width) / options.size.height);
}

render::Camera camera_of(const std::vector<render::Object>& objects, const glm::dvec3& middle,
                         const SceneOptions& options) {
    render::Camera camera = bare_camera(options);
    camera = options.eye
                 ? placed_camera(camera, *options.eye, objects, options.target.value_or(middle))
                 : framing_camera(camera, objects, options);
    camera.magnification *= options.zoom;
    return camera;
}

shading::Light<float> light_of(const LightOption& option, const render::Camera& camera,
                               float falloff_k) {
    if (option.frame == LightFrame::point) {
        return shading::point_light<float>(option.place, option.color,
                                           {option.falloff, option.falloff_k.value_or(falloff_k)});
    }
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(render::eye_from_world(camera)));
    const glm::dvec3 towards =
        option.frame == LightFrame::camera ? world_from_eye * option.place : option.place;
    return shading::directional_light<float>(towards, option.color);
}

shading::Lighting<float> lighting_of(const render::Camera& camera, const SceneOptions& options) {
    shading::Lighting<float> lighting{options.ambient, {}};
    for (const LightOption& light : lights_in(options))
        lighting.lights.push_back(light_of(light, camera, options.falloff_k));
    return lighting;
}

/// A picture's axes: a mirror ball is seen by the camera.
glm::mat3 environment_axes(const SceneOptions& options, const render::Camera& camera) {
    if (options.environment.layout == shading::EnvironmentLayout::sphere)
        return glm::mat3(glm::dmat3(render::eye_from_world(camera)));
    if (options.environment.layout == shading::EnvironmentLayout::cube)
        return render::cube_from_world;
    return shading::latitudes_from_y_up;
}

constexpr int cube_map_side = 512;

shading::Environment environment_of(const EnvironmentOptions& options) {
    const bool is_room = options.image == "room";
    if (!is_room)
        return scene_environment(options.image, options.layout, options.stated.at({"image"}));
    if (options.layout != shading::EnvironmentLayout::latitudes)
        throw UsageError(prefix_of(options.stated.at({"layout"})) +
                         "the built-in room is laid out by latitudes");
    return {options.layout, {render::room(512)}, glm::mat3(1.0f)};
}

/// Its axes are the camera's matter.
void add_environment(const SceneOptions& options, render::Scene& scene) {
    shading::Environment environment = environment_of(options.environment);
    scene.surroundings = std::make_shared<const shading::Environment>(environment);
    if (!options.environment.lights) return;
    environment.images = {shading::diffuse_environment(environment, 32, 64)};
    environment.layout = shading::EnvironmentLayout::latitudes;
    scene.diffuse = std::make_shared<const shading::Environment>(environment);
}

using EnvironmentPtr = std::shared_ptr<const shading::Environment>;

EnvironmentPtr turned(const EnvironmentPtr& environment, const glm::mat3& axes) {
    if (environment == nullptr) return nullptr;
    shading::Environment result = *environment;
    result.environment_from_world = axes;
    return std::make_shared<const shading::Environment>(std::move(result));
}

void turn_environment(const SceneOptions& options, render::Scene& scene) {
    const glm::mat3 axes = environment_axes(options, scene.camera);
    scene.surroundings = turned(scene.surroundings, axes);
    scene.diffuse = turned(scene.diffuse, axes);
    scene.mirrored = scene.surroundings;
    if (!options.environment.seen_from) return;
    scene.mirrored = std::make_shared<const shading::Environment>(
        render::cube_map(scene, options.settings, *options.environment.seen_from, cube_map_side));
}

/// With the planes that the scene and its shadows need.
render::Camera camera_before(const render::Scene& scene, const Models& models,
                             const SceneOptions& options) {
    const auto first = scene.objects.begin();
    const auto count = static_cast<std::ptrdiff_t>(models.of_object.size());
    render::Camera camera = camera_of({first, first + count}, models.box.center(), options);
    if (models.floor) camera = render::with_fitted_planes(camera, scene.objects);
    return render::counts_volumes(options.settings.shadows) ? render::with_room_for_shadows(camera)
                                                            : camera;
}

}  // namespace

render::Camera bare_camera(const SceneOptions& options) {
    render::Camera camera;
    camera.projection = options.projection;
    camera.up = options.up.value_or(camera.up);
    camera.magnification = magnification(options);
    return camera;
}

render::Scene unseen_scene_of(const Models& models, const SceneOptions& options) {
    render::Scene scene;
    scene.objects = objects_of(models, options);
    if (models.floor) scene.objects.push_back({&*models.floor, {white()}});
    if (!options.environment.image.empty()) add_environment(options, scene);
    scene.background =
        options.background ? raster::Rgba(*options.background, 1.0f) : raster::Rgba(0.0f);
    return scene;
}

render::Scene seen(render::Scene scene, const Models& models, const SceneOptions& options) {
    scene.camera = camera_before(scene, models, options);
    scene.lighting = lighting_of(scene.camera, options);
    turn_environment(options, scene);
    return scene;
}

render::Scene scene_of(const Models& models, const SceneOptions& options) {
    return seen(unseen_scene_of(models, options), models, options);
}

}  // namespace scanlight::apps
