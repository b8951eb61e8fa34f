#include "apps/scanlight/scene_setup.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "apps/scanlight/model_textures.h"
#include "apps/scanlight/usage_error.h"
#include "mesh/bounds.h"
#include "mesh/triangulate.h"
#include "raster/load_image.h"
#include "render/framing.h"
#include "render/material_textures.h"
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

shading::Material<float> plain_material(const SceneOptions& options) {
    const bool is_coloured = std::ranges::find(options.textures, TextureSlot::diffuse,
                                               &TextureOption::slot) != options.textures.end();
    return is_coloured ? colorless_clay() : clay();
}

bool has_own_materials(const mesh::Mesh& mesh) {
    return mesh.materials.size() > 1 || !mesh.materials.front().name.empty();
}

std::vector<shading::Material<float>> materials_of(const mesh::Mesh& mesh,
                                                   const SceneOptions& options) {
    auto materials = render::shading_materials(mesh.materials);
    if (!has_own_materials(mesh)) materials.front() = plain_material(options);
    for (auto& material : materials)
        material = parse_material(options.material, with_facets(material, options.facets));
    return materials;
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
                             const std::vector<render::Object>& objects,
                             const SceneOptions& options) {
    camera.eye = eye;
    camera.target = options.target.value_or(mesh::bounding_box(*objects.front().mesh).center());
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

render::Camera camera_of(const std::vector<render::Object>& objects, const SceneOptions& options) {
    render::Camera camera;
    camera.projection = options.projection;
    camera.magnification = magnification(options);
    camera = options.eye ? placed_camera(camera, *options.eye, objects, options)
                         : framing_camera(camera, objects, options);
    camera.magnification *= options.zoom;
    return camera;
}

shading::Light<float> light_of(const LightOption& option, const render::Camera& camera,
                               float falloff_k) {
    if (option.frame == LightFrame::point) {
        return shading::point_light<float>(option.place, option.color, {option.falloff, falloff_k});
    }
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(render::eye_from_world(camera)));
    const glm::dvec3 towards =
        option.frame == LightFrame::camera ? world_from_eye * option.place : option.place;
    return shading::directional_light<float>(towards, option.color);
}

shading::Lighting<float> lighting_of(const render::Camera& camera, const SceneOptions& options) {
    const LightOption from_the_upper_left{LightFrame::camera, glm::dvec3(-0.7, 0.7, 1.0)};
    const auto& lights = options.lights;
    shading::Lighting<float> lighting{options.ambient, {}};
    for (const auto& light : lights.empty() ? std::vector{from_the_upper_left} : lights) {
        lighting.lights.push_back(light_of(light, camera, options.falloff_k));
    }
    return lighting;
}

/// The materials' own, and over them those of the options.
std::vector<shading::SurfaceTextures> textures_on(const Model& model, const SceneOptions& options) {
    std::vector<shading::SurfaceTextures> textures = model.textures;
    if (options.textures.empty()) return textures;
    textures.resize(model.mesh.materials.size());
    const auto given = textures_of(options.textures, mesh::bounding_box(model.mesh));
    for (auto& own : textures)
        own = laid_over(own, given);
    return textures;
}

/// A picture's axes: y is up in the world, and a mirror ball is seen by the camera.
glm::mat3 environment_axes(const SceneOptions& options, const render::Camera& camera) {
    if (options.environment_layout == shading::EnvironmentLayout::sphere)
        return glm::mat3(glm::dmat3(render::eye_from_world(camera)));
    return {0, 1, 0, 0, 0, 1, 1, 0, 0};
}

std::shared_ptr<const shading::TexelImage> environment_image(const SceneOptions& options) {
    if (options.environment == "room") return render::room(512);
    auto image =
        render::texel_image(raster::load_image(options.environment), render::TexelMeaning::color);
    if (!image) throw UsageError(options.environment + ": too large for an environment");
    return image;
}

void add_environment(const SceneOptions& options, render::Scene& scene) {
    shading::Environment environment{options.environment_layout,
                                     {environment_image(options)},
                                     environment_axes(options, scene.camera)};
    scene.mirrored = std::make_shared<const shading::Environment>(environment);
    scene.surroundings = scene.mirrored;
    if (!options.environment_light) return;
    environment.images[0] = shading::diffuse_environment(environment, 32, 64);
    environment.layout = shading::EnvironmentLayout::latitudes;
    scene.diffuse = std::make_shared<const shading::Environment>(environment);
}

}  // namespace

Model load_model(const SceneOptions& options) {
    Model model = load_model(options.input, options.normals);
    if (options.polygons == Polygons::triangulated) model.mesh = mesh::triangulated(model.mesh);
    if (options.floor) model.floor = floor_beneath(model.mesh);
    for (const auto& left_out : render::approximations(model.mesh.materials))
        model.warnings.push_back(model.name + ": " + left_out);
    if (options.own_textures) load_textures(model, options.settings.shading);
    return model;
}

render::Scene scene_of(const Model& model, const SceneOptions& options) {
    render::Scene scene;
    scene.objects.push_back({&model.mesh, materials_of(model.mesh, options)});
    scene.objects.front().textures = textures_on(model, options);
    scene.camera = camera_of(scene.objects, options);
    if (model.floor) {
        scene.objects.push_back({&*model.floor, {white()}});
        scene.camera = render::with_fitted_planes(scene.camera, scene.objects);
    }
    if (render::counts_volumes(options.settings.shadows))
        scene.camera = render::with_room_for_shadows(scene.camera);
    scene.lighting = lighting_of(scene.camera, options);
    if (!options.environment.empty()) add_environment(options, scene);
    scene.background =
        options.background ? raster::Rgba(*options.background, 1.0f) : raster::Rgba(0.0f);
    return scene;
}

}  // namespace scanlight::apps
