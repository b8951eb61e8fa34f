#include <array>
#include <string>

#include "tests/same_bits/dressed_shapes.h"

namespace scanlight::same_bits {

namespace {

using namespace render;
using shading::Illumination;

struct Model {
    std::string name;
    Illumination illumination;
};

const std::array<Model, 2> models{
    {{"hall", Illumination::hall}, {"cook-torrance", Illumination::cook_torrance}}};
const std::array<std::pair<std::string, Shading>, 3> shadings{
    {{"flat", Shading::flat}, {"gouraud", Shading::gouraud}, {"phong", Shading::phong}}};

/// Lights before and behind, near and far.
TestScene lit_all_round(mesh::Mesh mesh, const Settings& settings) {
    TestScene test = shape_scene(std::move(mesh), {97, 65}, settings);
    test.scene.lighting.lights.push_back(sun({0.3f, -0.2f, -1.0f}));
    test.scene.lighting.lights.push_back(lamp({0.1f, 0.0f, 0.2f}, glm::vec3(0.6f)));
    return test;
}

/// A pane that lets light through and a block that does not, over a floor.
TestScene pane_and_block(const Settings& settings) {
    TestScene test{{90, 61}, settings, {}, {}};
    const mesh::Mesh& floor = test.keep(shape_mesh("plane:3"));
    const mesh::Mesh& cube = test.keep(shape_mesh("cube"));
    Object pane = object_of(cube);
    pane.materials.front().transmission = transmission(0);
    pane.world_from_object[2] *= 0.05;
    Object block = object_of(cube);
    block.world_from_object[0] *= 0.3;
    block.world_from_object[3] = glm::dvec4(0.9, -0.2, 1.2, 1.0);
    Object ground = object_of(floor);
    ground.world_from_object[0] *= 3.0;
    ground.world_from_object[2] *= 3.0;
    ground.world_from_object[3] = glm::dvec4(0.0, -1.0, 0.0, 1.0);
    test.scene = scene_of({pane, block, ground}, {{25.0, 30.0}, test.size});
    test.scene.lighting.lights = {lamp({0.3f, 1.2f, -2.0f}, glm::vec3(0.9f)),
                                  sun({-0.4f, 1.0f, 0.8f}, glm::vec3(0.4f))};
    return test;
}

}  // namespace

NamedScenes model_scenes() {
    NamedScenes scenes;
    for (const auto& [model, illumination] : models) {
        const auto add = [&scenes, &model = model](const std::string& name, auto make) {
            scenes.push_back({model + "/" + name, make});
        };
        for (const auto& [name, shading] : shadings) {
            const Settings s{.shading = shading, .illumination = illumination};
            add("motley/" + name, [s] { return lit_all_round(motley_shape("sphere:18,9", 9), s); });
            add("colored/" + name, [s] { return lit_all_round(colored_shape("torus:10,7"), s); });
            add("one/" + name, [s] { return lit_all_round(shape_mesh("teapot:3"), s); });
        }
        Settings infinite{.illumination = illumination, .distances = Distances::infinite};
        add("infinite", [=] { return lit_all_round(motley_shape("cube", 6), infinite); });
        const Settings one_side{.illumination = illumination, .sides = Sides::one};
        add("one-side", [=] { return lit_all_round(motley_shape("star:7", 3), one_side); });
        const Settings shadowed{.illumination = illumination, .shadows = Shadows::zfail};
        add("shadows", [=] { return pane_and_block(shadowed); });
    }
    return scenes;
}

}  // namespace scanlight::same_bits
