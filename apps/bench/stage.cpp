#include "apps/bench/stage.h"

#include "mesh/build.h"
#include "mesh/shapes.h"
#include "mesh/triangulate.h"
#include "render/framing.h"

namespace scanlight::bench {

namespace {

constexpr raster::Viewport size{1920, 1080};

render::Scene scene_of(const mesh::Mesh& mesh) {
    render::Scene scene;
    scene.objects.push_back(
        {&mesh, {{glm::vec3(0.1f), glm::vec3(0.6f), glm::vec3(0.3f), 32}}, glm::dmat4(1.0)});
    scene.lighting.ambient = glm::vec3(1.0f);
    scene.lighting.lights = {
        shading::directional_light(glm::vec3(0.3f, 0.6f, 1.0f), glm::vec3(1.0f))};
    scene.camera.eye = render::direction_of({});
    scene.camera =
        render::framed(scene.camera, scene.objects, static_cast<double>(size.width) / size.height);
    return scene;
}

}  // namespace

Stage::Stage(const std::string& shape)
    : name_(shape),
      mesh_(mesh::triangulated(mesh::build(mesh::shape(shape)).mesh)),
      scene_(scene_of(mesh_)),
      frame_(render::frame_of(scene_, render::Distances::finite, size)),
      placed_(render::placed(scene_.objects.front(), frame_)) {}

}  // namespace scanlight::bench
