#include <string>

#include "tests/render/scenes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/materials.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

namespace {

using namespace render;

/// How a scene with shadows is looked at.
struct ShadowView {
    std::string name;
    Camera camera;
};

Camera camera(const glm::dvec3& eye, double near, double far) {
    Camera result;
    result.eye = eye;
    result.target = {0.2, -0.5, 0.1};
    result.magnification = 1.6;
    result.near = near;
    result.far = far;
    return result;
}

std::vector<ShadowView> views() {
    Camera parallel = camera({3.0, 4.0, 5.0}, 1.0, 12.0);
    parallel.projection = Projection::orthographic;
    parallel.magnification = 0.4;
    return {{"around", camera({3.0, 3.0, 4.0}, 0.5, 20.0)},
            {"narrow", camera({3.0, 3.0, 4.0}, 3.0, 7.0)},      // depth ends before infinity
            {"inside", camera({1.05, -0.85, 1.0}, 0.02, 9.0)},  // a shadow
            {"cut", camera({3.0, 2.0, 4.0}, 4.6, 20.0)},        // by the near plane
            {"parallel", parallel}};
}

/// A ring of triangles, a teapot of quads and a mirrored block over a floor.
TestScene shadow_scene(const ShadowView& view, const Settings& settings) {
    TestScene test{{121, 90}, settings, {}, {}};
    const auto put = [&](const mesh::Mesh& mesh, double scale, const glm::dvec3& place) {
        Object object{&mesh, several_materials(mesh.materials.size())};
        for (int k = 0; k < 3; ++k)
            object.world_from_object[k][k] = scale;
        object.world_from_object[3] = glm::dvec4(place, 1.0);
        test.scene.objects.push_back(object);
    };
    put(test.keep(mesh::triangulated(shape_mesh("torus:14,9"))), 0.6, {0.4, 0.3, -0.2});
    put(test.keep(shape_mesh("teapot:3")), 0.4, {-0.7, -0.6, 0.8});
    put(test.keep(shape_mesh("cube")), 0.3, {1.1, -0.4, 1.0});
    test.scene.objects.back().world_from_object[0][0] *= -1.0;
    put(test.keep(shape_mesh("plane:3")), 3.0, {0.0, -1.0, 0.0});
    test.scene.camera = view.camera;
    test.scene.lighting = {glm::vec3(0.1f, 0.12f, 0.15f),
                           {lamp({1.5f, 2.5f, 1.0f}, {0.8f, 0.7f, 0.5f}),
                            sun({-0.5f, 0.9f, -0.6f}, {0.2f, 0.3f, 0.5f})}};
    test.scene.background = {0.5f, 0.6f, 0.7f, 1.0f};
    return test;
}

}  // namespace

NamedScenes shadow_scenes() {
    NamedScenes scenes;
    const auto add = [&](const ShadowView& view, const std::string& how, const Settings& settings) {
        scenes.push_back({"shadows/" + view.name + "/" + how,
                          [view, settings] { return shadow_scene(view, settings); }});
    };
    const auto all_views = views();
    for (const ShadowView& view : all_views) {
        add(view, "phong-zfail", {.shadows = Shadows::zfail});
        add(view, "flat-zpass", {.shading = Shading::flat, .shadows = Shadows::zpass});
        add(view, "gouraud-zfail", {.shading = Shading::gouraud, .shadows = Shadows::zfail});
        add(view, "phong-zpass-from-zero", {.shadows = Shadows::zpass_from_zero});
        add(view, "phong-map", {.shadows = Shadows::map, .shadow_map = {.size = 256}});
    }
    const ShadowView& first = all_views.front();
    add(first, "flat-map",
        {.shading = Shading::flat, .shadows = Shadows::map, .shadow_map = {.size = 300}});
    add(first, "gouraud-map",
        {.shading = Shading::gouraud, .shadows = Shadows::map, .shadow_map = {.size = 256}});
    add(first, "phong-map-filtered",
        {.shadows = Shadows::map, .shadow_map = {.size = 256, .filter = 3}});
    add(first, "phong-map-cull",
        {.cull = Cull::back, .shadows = Shadows::map, .shadow_map = {.size = 256}});
    add(first, "phong-polygons", {.shadows = Shadows::polygons});
    add(first, "gouraud-polygons", {.shading = Shading::gouraud, .shadows = Shadows::polygons});
    add(first, "phong-zfail-cull", {.cull = Cull::back, .shadows = Shadows::zfail});
    return scenes;
}

}  // namespace scanlight::same_bits
