#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

#include <glm/ext/matrix_transform.hpp>

#include "tests/render/scenes.h"
#include "tests/same_bits/dressed_shapes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/materials.h"
#include "tests/same_bits/pixel_view.h"
#include "tests/same_bits/plain_mesh.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

namespace {

using namespace render;

constexpr Settings flat{.shading = Shading::flat};
constexpr Settings gouraud{.shading = Shading::gouraud};
constexpr Settings phong{};

// ---- what a mesh may carry

TestScene colored(const Settings& settings) {
    return shape_scene(colored_shape("torus:10,7"), {97, 65}, settings);
}
TestScene motley(const Settings& settings) {
    return shape_scene(motley_shape("sphere:9,7", 5), {97, 65}, settings);
}

/// Light of its own, of each material another.
TestScene glowing(const Settings& settings) {
    TestScene test = shape_scene(motley_shape("torus:9,7", 4), {97, 65}, settings);
    auto& materials = test.scene.objects[0].materials;
    for (std::size_t i = 0; i < materials.size(); ++i)
        materials[i].emission = glm::vec3(0.1f * static_cast<float>(i), 0.3f, 0.7f);
    return test;
}

// ---- objects

/// Three of them, the second mirrored, the third in colours and squeezed flat.
TestScene several_objects(const Settings& settings) {
    TestScene test{{110, 75}, settings, {}, {}};
    const mesh::Mesh& torus = test.keep(shape_mesh("torus:12,8"));
    const mesh::Mesh& teapot = test.keep(shape_mesh("teapot:3"));
    const mesh::Mesh& cube = test.keep(colored_shape("cube"));
    Object mirrored = object_of(teapot);
    mirrored.world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(-0.9, 0.8, 0.7));
    Object squeezed = object_of(cube);
    const glm::dmat4 turned(glm::dvec4(0.6, 0.8, 0.0, 0.0), glm::dvec4(-0.8, 0.6, 0.0, 0.0),
                            glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
    squeezed.world_from_object = glm::scale(turned, glm::dvec3(1.2, 0.05, 0.9));
    test.scene = scene_of({object_of(torus), mirrored, squeezed}, {{}, test.size});
    test.scene.lighting = lighting(4);
    return test;
}

/// Each of them drawn in its own way.
TestScene own_settings(const Settings& settings) {
    TestScene test = several_objects(settings);
    auto& objects = test.scene.objects;
    objects[0].own = {.shading = Shading::flat, .illumination = shading::Illumination::blinn};
    objects[1].own = {
        .shading = Shading::gouraud, .perspective = Perspective::affine, .sides = Sides::one};
    objects[2].own.cull = Cull::front;
    objects.push_back(objects[1]);
    objects.back().own = {.illumination = shading::Illumination::gouraud71, .gouraud71_k = 0.5f};
    objects.back().world_from_object[3] = glm::dvec4(0.5, 0.5, -0.5, 1.0);
    return test;
}

/// The same without Gouraud shading and culling, which shadows of the fast path don't know.
TestScene own_settings_in_shadows() {
    TestScene test = own_settings({.shadows = Shadows::zfail});
    test.scene.objects[1].own = {.shading = Shading::flat};
    test.scene.objects[2].own = {.illumination = shading::Illumination::lambert};
    return test;
}

/// Many samples a pixel.
TestScene sampled(TestScene test, int grid) {
    test.settings.grid = grid;
    return test;
}

/// Pixels that are covered in part before nothing.
TestScene sampled_before_nothing(const Settings& settings) {
    TestScene test = sampled(several_objects(settings), 4);
    test.scene.background = raster::Rgba(0.0f);
    return test;
}

/// A matrix that leaves no volume: normals have no inverse to be turned by.
TestScene flattened() {
    TestScene test = shape_scene(shape_mesh("icosphere:2"), {64, 64}, phong);
    test.scene.objects[0].world_from_object[2] = glm::dvec4(0.0);
    return test;
}

TestScene nothing() {
    TestScene test{{37, 40}, phong, {}, {}};
    test.scene.background = {0.5f, 2.0f, -1.0f, 0.0f};
    return test;
}

/// Objects without polygons, out of sight and behind the eye, and one to be seen.
TestScene hardly_anything() {
    TestScene test{{45, 33}, gouraud, {}, {}};
    const mesh::Mesh& empty = test.keep(plain_mesh({}));
    const mesh::Mesh& cube = test.keep(shape_mesh("cube"));
    test.scene = scene_of(cube, {{}, test.size});
    Object behind = test.scene.objects[0];
    behind.world_from_object[3] = glm::dvec4(4.0 * test.scene.camera.eye, 1.0);
    Object aside = test.scene.objects[0];
    aside.world_from_object[3] = glm::dvec4(0.0, 50.0, 0.0, 1.0);
    test.scene.objects = {object_of(empty), behind, test.scene.objects[0], aside};
    return test;
}

// ---- lights

/// Vertices so bright that they are interpolated as multiples of a power of two.
TestScene bright(float intensity, const Settings& settings) {
    TestScene test = shape_scene(shape_mesh("torus:12,8"), {90, 61}, settings);
    test.scene.lighting.lights = {sun({-0.5f, 0.7f, 1.0f}, glm::vec3(intensity)),
                                  sun({1.0f, 0.0f, 0.2f}, glm::vec3(1.0f, 0.0f, 0.5f))};
    return test;
}

TestScene dark() {
    TestScene test = shape_scene(shape_mesh("cube"), {40, 40}, phong);
    test.scene.lighting = {};
    return test;
}

/// A lamp in the very point of a vertex, and one in the eye.
TestScene lamps_where_they_should_not_be(const Settings& settings) {
    TestScene test = shape_scene(shape_mesh("octahedron"), {70, 70}, settings);
    const glm::vec3 vertex = test.meshes[0]->vertices.position(0);
    test.scene.lighting.lights = {lamp(vertex, glm::vec3(0.5f)),
                                  lamp(glm::vec3(test.scene.camera.eye), glm::vec3(0.5f))};
    return test;
}

// ---- the eye

/// Within the tube of a torus: polygons on all sides, most of them clipped.
TestScene from_within(const Settings& settings) {
    TestScene test = shape_scene(shape_mesh("torus:20,12"), {120, 80}, settings);
    test.scene.camera = {.eye = {0.7, 0.0, 0.0}, .target = {0.4, 0.1, -0.5}, .near = 0.01};
    test.scene.lighting = lighting(1);
    return test;
}

/// A floor that runs beneath the eye to the horizon: 1/w over four decades.
TestScene floor_to_the_horizon(const Settings& settings) {
    TestScene test = shape_scene(colored_shape("plane:3"), {120, 80}, settings);
    test.scene.objects[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(60.0));
    test.scene.camera = {
        .eye = {0.5, 0.02, 1.0}, .target = {0.0, 0.0, -3.0}, .near = 0.001, .far = 90.0};
    return test;
}

TestScene edge_on() {
    TestScene test{{80, 50}, gouraud, {}, {}};
    const mesh::Mesh& plane = test.keep(shape_mesh("plane:4"));
    test.scene = scene_of(plane, {{30.0, 0.0}, test.size, Projection::orthographic});
    return test;
}

TestScene close_star(const Settings& settings) {
    TestScene test = shape_scene(shape_mesh("star:7"), {90, 90}, settings);
    test.scene.camera.eye = {0.2, -0.1, 0.5};
    test.scene.camera.target = {0.0, 0.1, 0.0};
    test.scene.camera.near = 0.4;
    return test;
}

// ---- sizes of pictures and of polygons

TestScene sized(std::string_view shape, raster::Viewport size, const Settings& settings) {
    return shape_scene(shape_mesh(shape), size, settings);
}

glm::vec3 leaning_normal(int i) {
    return glm::normalize(glm::vec3(0.1f * static_cast<float>(i % 7 - 3), 0.3f, 1.0f));
}

/// Right-angled triangles of so many pixels each way, in a heap.
std::vector<PlainPolygon> steps_of_triangles(double least, double most, double step) {
    std::vector<PlainPolygon> triangles;
    int i = 0;
    for (double size = least; size <= most; size += step, ++i) {
        const double left = 0.5 * i;
        const double z = 0.01 * i;
        const glm::vec3 n = leaning_normal(i);
        triangles.push_back({{{at_pixel(left, 3.5, z), n},
                              {at_pixel(left, 3.5 + size, z + 0.5), -n},
                              {at_pixel(left + size, 3.5 + size, z), leaning_normal(i + 3)}},
                             n});
    }
    return triangles;
}

TestScene in_pixels(const std::vector<PlainPolygon>& polygons, raster::Viewport size,
                    const Settings& settings) {
    TestScene test{size, settings, {}, {}};
    test.scene.objects = {object_of(test.keep(plain_mesh(polygons)))};
    test.scene.camera = pixel_camera(size);
    test.scene.lighting = lighting(0);
    return test;
}

/// Where triangles stop to be small ones, at 64 pixels, by 1/128 pixel.
TestScene about_64_pixels(const Settings& settings) {
    return in_pixels(steps_of_triangles(63.75, 64.25, 1.0 / 128), {120, 90}, settings);
}

/// One triangle over the longest rows, or columns, that there are.
TestScene longest(raster::Viewport size, const Settings& settings) {
    const double w = size.width;
    const double h = size.height;
    const glm::vec3 n = leaning_normal(0);
    const PlainPolygon triangle{{{at_pixel(0.0, 0.0, lowest_z), n},
                                 {at_pixel(0.0, h, 1.0 / 3), leaning_normal(1)},
                                 {at_pixel(w, h, highest_z), leaning_normal(5)}},
                                n};
    const PlainPolygon quad{{{at_pixel(0.0, 0.0, 0.0), n},
                             {at_pixel(0.0, h, 1.0), leaning_normal(2)},
                             {at_pixel(w, h, 0.1), -leaning_normal(4)},
                             {at_pixel(w, 0.0, -1.0), leaning_normal(6)}},
                            n};
    return in_pixels({triangle, quad}, size, settings);
}

/// Normals that cancel half-way: there the polygon's own is lit.
TestScene opposed_normals() {
    const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 1.0f, 0.5f));
    const PlainPolygon quad{{{at_pixel(0.0, 0.0, 0.0), n},
                             {at_pixel(0.0, 64.0, 0.0), n},
                             {at_pixel(65.0, 64.0, 0.0), -n},
                             {at_pixel(65.0, 0.0, 0.0), -n}},
                            glm::vec3(0.0f, 0.0f, 1.0f)};
    return in_pixels({quad}, {65, 64}, phong);
}

void add(NamedScenes& to, NamedScenes more) {
    std::ranges::move(more, std::back_inserter(to));
}

/// One scene by all three shadings.
template <class Make>
NamedScenes by_each_shading(const std::string& name, Make make) {
    return {{name + "/flat", [=] { return make(flat); }},
            {name + "/gouraud", [=] { return make(gouraud); }},
            {name + "/phong", [=] { return make(phong); }}};
}

}  // namespace

NamedScenes special_scenes() {
    const Settings culled{.shading = Shading::gouraud, .cull = Cull::back};
    const Settings affine{.shading = Shading::gouraud, .perspective = Perspective::affine};
    NamedScenes scenes{
        {"flattened", flattened},
        {"nothing", nothing},
        {"hardly-anything", hardly_anything},
        {"dark", dark},
        {"edge-on", edge_on},
        {"opposed-normals", opposed_normals},
        {"own-settings/shadows", own_settings_in_shadows},
        {"own-settings/shadows-by-the-textbook",
         [] { return own_settings({.shadows = Shadows::zfail}); }},
        {"samples/4/own-settings", [] { return sampled(own_settings(gouraud), 2); }},
        {"samples/16/shadows", [] { return sampled(own_settings_in_shadows(), 4); }},
        {"samples/16/nothing", [] { return sampled(nothing(), 4); }},
        {"several-objects/gouraud-cull-back", [=] { return several_objects(culled); }},
        {"bright/60/gouraud", [] { return bright(60.0f, gouraud); }},
        {"bright/60/phong", [] { return bright(60.0f, phong); }},
        {"bright/1e20/gouraud", [] { return bright(1e20f, gouraud); }},
        {"bright/1e20/gouraud-affine", [=] { return bright(1e20f, affine); }},
        {"floor-to-the-horizon/gouraud-affine", [=] { return floor_to_the_horizon(affine); }},
        {"slivers/gouraud",
         [] {
             return sized("sphere:300,2", {130, 70}, gouraud);
         }},
        {"slivers/phong",
         [] {
             return sized("cylinder:150", {70, 130}, phong);
         }},
        {"many-specks/flat",
         [] {
             return sized("icosphere:5", {97, 65}, flat);
         }},
        {"many-specks/gouraud",
         [] {
             return sized("icosphere:5", {97, 65}, gouraud);
         }},
        {"many-specks/phong",
         [] {
             return sized("icosphere:5", {64, 48}, phong);
         }},
        {"longest-row/gouraud",
         [] {
             return longest({16384, 1}, gouraud);
         }},
        {"longest-row/phong",
         [] {
             return longest({16384, 2}, phong);
         }},
        {"longest-column/gouraud",
         [] {
             return longest({1, 16384}, gouraud);
         }},
        {"large/gouraud",
         [] {
             return sized("octahedron", {333, 300}, gouraud);
         }},
    };
    add(scenes, by_each_shading("colored", colored));
    add(scenes, by_each_shading("motley", motley));
    add(scenes, by_each_shading("glowing", glowing));
    scenes.push_back({"glowing/shadows", [] { return glowing({.shadows = Shadows::zfail}); }});
    add(scenes, by_each_shading("several-objects", several_objects));
    add(scenes, by_each_shading("own-settings", own_settings));
    add(scenes, by_each_shading("samples/16", sampled_before_nothing));
    add(scenes, by_each_shading("lamp-in-vertex-and-eye", lamps_where_they_should_not_be));
    add(scenes, by_each_shading("from-within", from_within));
    add(scenes, by_each_shading("floor-to-the-horizon", floor_to_the_horizon));
    add(scenes, by_each_shading("close-star", close_star));
    add(scenes, by_each_shading("about-64-pixels", about_64_pixels));
    return scenes;
}

}  // namespace scanlight::same_bits
