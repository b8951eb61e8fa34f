#include <array>
#include <string_view>

#include "tests/render/scenes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

namespace {

using namespace render;

// The numbers of shapes and sizes have no divisor in common with each other or with the settings'
// 36 mixtures, so that each meets many of them.
constexpr std::array<std::string_view, 11> shapes{
    "cube",   "octahedron", "icosphere:2", "sphere:12,6", "torus:12,8", "cylinder:9",
    "cone:7", "plane:4",    "ngon:7",      "star:5",      "teapot:3"};
constexpr std::array<raster::Viewport, 7> sizes{
    {{64, 48}, {1, 1}, {3, 257}, {97, 65}, {301, 217}, {640, 33}, {31, 32}}};
constexpr std::array shading_names{"flat", "gouraud", "phong"};
constexpr std::array illumination_names{"lambert", "gouraud71", "phong", "blinn"};
constexpr std::array perspective_names{"affine", "correct"};
constexpr std::array cull_names{"no-cull", "cull-back", "cull-front"};
constexpr std::array side_names{"one-side", "two-sides"};
constexpr int mixtures = 36;

template <std::size_t n>
std::string_view name_of(const std::array<const char*, n>& names, auto value) {
    return names[static_cast<std::size_t>(value)];
}

/// The i-th of `mixtures` of shading, perspective, culling and sides; the others go along.
Settings mixture(int i) {
    Settings s;
    s.shading = static_cast<Shading>(i % 3);
    s.perspective = static_cast<Perspective>(i / 3 % 2);
    s.cull = static_cast<Cull>(i / 6 % 3);
    s.sides = static_cast<Sides>(i / 18 % 2);
    s.illumination = static_cast<shading::Illumination>((i + i / 4) % 4);
    s.distances = i % 5 == 4 ? Distances::infinite : Distances::finite;
    return s;
}

std::string_view shape_of(int i) {
    return shapes[static_cast<std::size_t>(i) % shapes.size()];
}
raster::Viewport size_of(int i) {
    return sizes[static_cast<std::size_t>(i) % sizes.size()];
}

std::string name_of_mixture(int i) {
    const Settings s = mixture(i);
    std::string name = "mix";
    for (const std::string_view part :
         {shape_of(i), name_of(shading_names, s.shading),
          name_of(illumination_names, s.illumination), name_of(perspective_names, s.perspective),
          name_of(cull_names, s.cull), name_of(side_names, s.sides)})
        name.append("/").append(part);
    const auto [width, height] = size_of(i);
    return name + "/" + std::to_string(width) + "x" + std::to_string(height);
}

/// So near that much lies beyond the picture's edges and some behind the eye.
void approach(Camera& camera) {
    camera.eye = camera.target + 0.35 * (camera.eye - camera.target);
    camera.near = 0.05;
}

TestScene scene_of_mixture(int i) {
    TestScene test{size_of(i), mixture(i), {}, {}};
    const View view{{30.0 + 47 * i, -80.0 + i * 37 % 160},
                    test.size,
                    i % 8 == 5 ? Projection::orthographic : Projection::perspective};
    test.scene = scene_of(test.keep(shape_mesh(shape_of(i))), view);
    test.scene.lighting = lighting(i % lightings);
    if (i % 4 == 3) approach(test.scene.camera);
    return test;
}

}  // namespace

NamedScenes mixed_scenes() {
    NamedScenes scenes;
    for (int i = 0; i < mixtures; ++i)
        scenes.push_back({name_of_mixture(i), [i] { return scene_of_mixture(i); }});
    return scenes;
}

}  // namespace scanlight::same_bits
