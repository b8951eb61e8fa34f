// What a program that uses Scanlight looks like: a cube, a camera, a light, a picture.

#include <mesh/build.h>
#include <mesh/shapes.h>
#include <render/draw.h>
#include <render/framing.h>

#include <cstdio>

using namespace scanlight;

namespace {

render::Scene scene_of(const mesh::Mesh& mesh) {
    render::Scene scene;
    scene.objects.push_back({&mesh, {{}}});
    scene.lighting.lights = {shading::directional_light(glm::vec3(1, 2, 3), glm::vec3(1))};
    scene.camera = render::framed({}, scene.objects, 1.0);
    return scene;
}

}  // namespace

int main() {
    const mesh::Mesh cube = mesh::build(mesh::shape("cube")).mesh;
    const auto picture = render::draw(scene_of(cube), {}, {64, 64}).framebuffer;
    const bool hit = picture.color.at(32, 32).a == 1 && picture.color.at(32, 32).g > 0;
    const bool missed = picture.color.at(0, 0).a == 0;
    if (!hit || !missed) std::puts("the picture is not that of a lit cube");
    return hit && missed ? 0 : 1;
}
