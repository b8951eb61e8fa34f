#include "apps/peers/stage.h"

#include <utility>

#include <glm/geometric.hpp>

#include "render/framing.h"
#include "shading/metals.h"

namespace scanlight::peers {

namespace {

render::Camera framed_camera(const render::Scene& scene, double aspect) {
    render::Camera camera;
    camera.eye = render::direction_of({});
    return render::framed(camera, scene.objects, aspect);
}

/// A framed ball ends at the picture's lower edge: here it reaches the corners.
render::Camera filled_camera(const render::Scene& scene, double aspect) {
    render::Camera camera = framed_camera(scene, aspect);
    camera.magnification *= 1.1 * glm::length(glm::dvec2(aspect, 1.0));
    return camera;
}

render::Camera window_camera(const render::Scene& scene) {
    render::Camera camera;
    camera.eye = {0.0, 0.0, window_distance()};
    return render::with_fitted_planes(camera, scene.objects);
}

render::Camera camera_of(const render::Scene& scene, View view, double aspect) {
    switch (view) {
        case View::framed:
            return framed_camera(scene, aspect);
        case View::filled:
            return filled_camera(scene, aspect);
        case View::window:
            break;
    }
    return window_camera(scene);
}

shading::Material<float> material() {
    shading::Material<float> material{glm::vec3(0.1f), {0.6f, 0.5f, 0.35f}, glm::vec3(0.3f), 32};
    const shading::Metal& copper = shading::metals().front();
    material.facets = {
        {shading::FacetDistribution::beckmann, 0.3}, shading::metal(copper.n, copper.k), 0.6};
    return material;
}

render::Scene scene_of(const mesh::Mesh& mesh, View view, double aspect) {
    render::Scene scene;
    scene.objects.push_back({&mesh, {material()}, glm::dmat4(1.0)});
    scene.lighting.ambient = glm::vec3(1.0f);
    scene.lighting.lights = {
        shading::directional_light(glm::vec3(0.3f, 0.6f, 1.0f), glm::vec3(1.0f))};
    scene.camera = camera_of(scene, view, aspect);
    return scene;
}

/// A file may bring several: here all is of one.
mesh::Mesh of_one_material(mesh::Mesh mesh) {
    mesh.face_material.assign(mesh.face_count(), 0);
    mesh.materials.resize(1);
    for (auto* channel : {&mesh.vertices.red, &mesh.vertices.green, &mesh.vertices.blue})
        channel->clear();
    return mesh;
}

}  // namespace

double window_distance() {
    return render::Camera{}.magnification;
}

double aspect_of(raster::Viewport size) {
    return static_cast<double>(size.width) / size.height;
}

Stage::Stage(mesh::Mesh mesh, View view, raster::Viewport size)
    : mesh_(of_one_material(std::move(mesh))),
      size_(size),
      scene_(scene_of(mesh_, view, aspect_of(size))) {}

void Stage::wear(Coat coat) {
    auto& textures = scene_.objects.front().textures;
    textures.clear();
    if (coat != Coat::none) textures.push_back(coat_textures(coat));
}

std::size_t triangle_count(const mesh::Mesh& mesh) {
    return mesh.corners.size() - 2 * mesh.face_count();
}

}  // namespace scanlight::peers
