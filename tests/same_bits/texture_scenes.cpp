#include <string>
#include <vector>

#include "shading/slopes.h"
#include "tests/render/scenes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/materials.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

namespace {

using namespace render;
using shading::Filter;
using shading::Mapping;
using shading::Pattern;
using shading::SurfaceTextures;
using shading::Texture;
using shading::Wrap;

/// Sides that are no powers of two, and texels that are no whole bytes; brighter than white where
/// `most` is more than 1.
std::shared_ptr<const shading::TexelImage> test_image(int width, int height, float most = 1.0f) {
    std::vector<float> rgba;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int step : {3, 5, 7, 11})
                rgba.push_back(static_cast<float>((x * step + y * (step + 2)) % 17) *
                               (most / 16.0f));
        }
    }
    return std::make_shared<const shading::TexelImage>(width, height, rgba);
}

Texture image(Filter filter, Wrap wrap) {
    Texture t;
    t.pattern = Pattern::image;
    t.image = test_image(45, 23);
    t.filter = filter;
    t.wrap = wrap;
    t.repeat = {3.0f, 2.5f};
    t.offset = {-0.3f, 0.7f};
    return t;
}

Texture slopes(Filter filter, Wrap wrap) {
    Texture t = image(filter, wrap);
    t.image = std::make_shared<const shading::TexelImage>(shading::slopes_of(*t.image, wrap));
    return t;
}

/// Of which some faces are seen from so near that texels cover pixels, others from farther away.
Texture large_texels(float most = 1.0f) {
    Texture t = image(Filter::trilinear, Wrap::repeat);
    t.image = test_image(13, 9, most);
    t.repeat = {-1.0f, 0.8f};
    return t;
}

SurfaceTextures large_bumps() {
    Texture t = large_texels();
    t.image = std::make_shared<const shading::TexelImage>(shading::slopes_of(*t.image, t.wrap));
    SurfaceTextures textures;
    textures.bump = t;
    textures.bump_height = 0.03f;
    return textures;
}

Texture pattern(Pattern pattern, Mapping mapping) {
    Texture t;
    t.pattern = pattern;
    t.mapping = mapping;
    t.low = {0.2f, 0.1f, 0.05f};
    t.high = {0.9f, 0.8f, 0.7f};
    // Around the y axis, which is up, and turned a little.
    t.texture_from_object = glm::mat4(0.8f, 0.0f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f,  //
                                      0.6f, 0.0f, -0.8f, 0.0f, 0.1f, 0.2f, 0.3f, 1.0f);
    return t;
}

Texture solid(Pattern kind, float scale) {
    Texture t = pattern(kind, Mapping::uv);
    for (int k = 0; k < 3; ++k)
        t.texture_from_object[k] *= scale;
    return t;
}

TestScene textured_scene(const std::string& shape, const SurfaceTextures& textures,
                         const Settings& settings) {
    TestScene test{{97, 71}, settings, {}, {}};
    const mesh::Mesh& mesh = test.keep(shape_mesh(shape));
    Object object{&mesh, several_materials(mesh.materials.size())};
    object.textures.assign(mesh.materials.size(), textures);
    object.world_from_object[0][0] = 1.2;
    object.world_from_object[3] = glm::dvec4(0.1, -0.1, 0.2, 1.0);
    if (textures.emission) {
        for (auto& material : object.materials)
            material.emission = {0.5f, 0.7f, 0.2f};
    }
    test.scene.objects.push_back(object);
    test.scene.camera.eye = {1.1, 0.9, 2.0};
    test.scene.camera.magnification = 1.6;
    test.scene.camera.near = 0.2;
    test.scene.camera.far = 9.0;
    test.scene.lighting = {glm::vec3(0.1f, 0.12f, 0.15f),
                           {lamp({1.5f, 2.5f, 1.0f}, {0.8f, 0.7f, 0.5f}),
                            sun({-0.5f, 0.9f, 0.6f}, {0.2f, 0.3f, 0.5f})}};
    return test;
}

/// Lit from far away only.
TestScene sunny_scene(const std::string& shape, const SurfaceTextures& textures,
                      const Settings& settings) {
    TestScene test = textured_scene(shape, textures, settings);
    test.scene.lighting.lights.erase(test.scene.lighting.lights.begin());
    return test;
}

struct NamedTextures {
    std::string name;
    SurfaceTextures textures;
};

std::vector<NamedTextures> several_textures() {
    std::vector<NamedTextures> all;
    const auto add = [&](const std::string& name) -> SurfaceTextures& {
        return all.emplace_back(NamedTextures{name, {}}).textures;
    };
    add("nearest-repeat").diffuse = image(Filter::nearest, Wrap::repeat);
    add("bilinear-clamp").diffuse = image(Filter::bilinear, Wrap::clamp);
    add("bilinear-mirror").specular = image(Filter::bilinear, Wrap::mirror);
    add("trilinear-repeat").diffuse = image(Filter::trilinear, Wrap::repeat);
    add("checker-spherical").diffuse = pattern(Pattern::checker, Mapping::spherical);
    add("stripes-cylindrical").diffuse = pattern(Pattern::stripes, Mapping::cylindrical);
    add("gradient-chapter-cylinder").ambient =
        pattern(Pattern::gradient, Mapping::chapter_cylinder);
    add("waves-planar").exponent = pattern(Pattern::waves, Mapping::planar);
    add("wood").diffuse = solid(Pattern::wood, 300.0f);
    add("marble").diffuse = solid(Pattern::marble, 3.0f);
    add("solid-checker").diffuse = solid(Pattern::solid_checker, 4.0f);
    add("bump-waves").bump = pattern(Pattern::waves, Mapping::uv);
    all.back().textures.bump_height = 0.05f;
    add("bump-image").bump = slopes(Filter::trilinear, Wrap::repeat);
    all.back().textures.bump_height = 0.03f;
    add("bump-mirror").bump = slopes(Filter::bilinear, Wrap::mirror);
    all.back().textures.bump_height = 0.05f;
    add("bump-marble").bump = solid(Pattern::marble, 3.0f);
    add("normal-map").normal = image(Filter::bilinear, Wrap::repeat);
    add("emission").emission = image(Filter::trilinear, Wrap::clamp);
    all.back().textures.exponent = pattern(Pattern::waves, Mapping::planar);
    SurfaceTextures& everything = add("everything");
    everything = all[3].textures;
    everything.specular = all[4].textures.diffuse;
    everything.exponent = all[7].textures.exponent;
    everything.bump = all[11].textures.bump;
    everything.bump_height = 0.04f;
    return all;
}

}  // namespace

NamedScenes texture_scenes() {
    NamedScenes scenes;
    const auto add = [&](const std::string& name, const std::string& shape,
                         const SurfaceTextures& textures, const Settings& settings) {
        scenes.push_back({"textures/" + name, [shape, textures, settings] {
                              return textured_scene(shape, textures, settings);
                          }});
    };
    const auto all = several_textures();
    for (const auto& [name, textures] : all)
        add(name, "torus:16,9", textures, {});
    for (const std::string shape : {"cube", "sphere:7,5", "teapot:2", "plane:1"})
        add("everything-" + shape.substr(0, shape.find(':')), shape, all.back().textures, {});
    const auto add_sunny = [&](const std::string& name, const std::string& shape,
                               const SurfaceTextures& textures, const Settings& settings) {
        scenes.push_back({"textures/" + name, [shape, textures, settings] {
                              return sunny_scene(shape, textures, settings);
                          }});
    };
    for (const std::string shape : {"cube", "torus:16,9", "plane:1"}) {
        const std::string name = "-" + shape.substr(0, shape.find(':'));
        SurfaceTextures textures;
        textures.diffuse = large_texels();
        add_sunny("large-texels" + name, shape, textures, {});
        textures.diffuse = large_texels(5.0f);
        add_sunny("large-bright-texels" + name, shape, textures, {});
        add_sunny("large-bumps" + name, shape, large_bumps(), {});
        add_sunny("large-affine-bumps" + name, shape, large_bumps(),
                  {.perspective = Perspective::affine});
    }
    add("affine", "cylinder:9", all[3].textures, {.perspective = Perspective::affine});
    add("front", "cylinder:9", all.back().textures, {.cull = Cull::front});
    add("shadows", "torus:12,7", all.back().textures, {.shadows = Shadows::zfail});
    return scenes;
}

namespace {

/// Two bodies that go through each other, one of glass, and one of glass and other things, over a
/// floor; the glass has the first or the last place among the objects.
TestScene glass_scene(bool glass_first, const Settings& settings) {
    TestScene test = textured_scene("plane:3", {}, settings);
    test.scene.objects.front().world_from_object[3].y = -0.7;
    Object ring = test.scene.objects.front();
    ring.mesh = &test.keep(shape_mesh("torus:14,9"));
    ring.materials.front().opacity = 0.4f;
    ring.world_from_object[3] = glm::dvec4(0.1, 0.0, 0.0, 1.0);
    Object teapot = ring;
    mesh::Mesh mesh = shape_mesh("teapot:2");
    mesh.materials.resize(2);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        mesh.face_material[f] = f % 3 == 0 ? 1 : 0;
    teapot.mesh = &test.keep(mesh);
    teapot.materials = several_materials(2);
    teapot.materials.back().opacity = 0.7f;
    teapot.textures.clear();
    if (settings.shading == Shading::phong) {
        teapot.textures.resize(2);
        teapot.textures.back().opacity = pattern(Pattern::checker, Mapping::spherical);
    }
    test.scene.objects.push_back(teapot);
    test.scene.objects.insert(glass_first ? test.scene.objects.begin() : test.scene.objects.end(),
                              ring);
    test.scene.background = {0.3f, 0.4f, 0.5f, 1.0f};
    return test;
}

/// Each of them drawn in its own way.
TestScene own_glass_scene(const Settings& settings, Shading of_ring) {
    TestScene test = glass_scene(false, settings);
    test.scene.objects[1].own = {.illumination = shading::Illumination::hall};
    test.scene.objects[2].own = {.shading = of_ring, .sides = Sides::one};
    return test;
}

/// Glass that changes the colour of what is behind it: of the ring, and of a part of the teapot.
TestScene stained(TestScene test) {
    for (Object& object : test.scene.objects)
        object.materials.back().filter = {0.9f, 0.3f, 0.5f};
    return test;
}

/// In the light of an environment, which is mirrored and seen.
TestScene room_scene(shading::EnvironmentLayout layout, const Settings& settings) {
    TestScene test = glass_scene(false, settings);
    shading::Environment environment{layout, {}, glm::mat3(0, 1, 0, 0, 0, 1, 1, 0, 0)};
    environment.images.fill(test_image(31, 17));
    test.scene.mirrored = std::make_shared<const shading::Environment>(environment);
    test.scene.surroundings = test.scene.diffuse = test.scene.mirrored;
    for (Object& object : test.scene.objects)
        object.materials.back().mirror = {0.5f, 0.6f, 0.3f};
    return test;
}

/// Of some materials the environment mirrored is their own; some glow, too.
TestScene own_room_scene(const Settings& settings) {
    TestScene test = room_scene(shading::EnvironmentLayout::latitudes, settings);
    shading::Environment own{shading::EnvironmentLayout::cube, {}, glm::mat3(1.0f)};
    own.images.fill(test_image(9, 9));
    for (Object& object : test.scene.objects) {
        object.textures.resize(object.materials.size());
        object.textures.back().mirrored = std::make_shared<const shading::Environment>(own);
        object.materials.front().emission = {0.3f, 0.2f, 0.1f};
    }
    return test;
}

/// Seen through the things, the first of which is denser than the room, the others thinner.
TestScene refracting_scene(const Settings& settings) {
    TestScene test = room_scene(shading::EnvironmentLayout::latitudes, settings);
    double eta = 1.5;
    for (Object& object : test.scene.objects) {
        for (auto& material : object.materials) {
            material.refracted = {0.4f, 0.7f, 0.5f};
            material.transmission.eta = eta;
        }
        eta = 0.75;
    }
    return test;
}

}  // namespace

NamedScenes room_scenes() {
    NamedScenes scenes;
    const auto add = [&](const std::string& name, shading::EnvironmentLayout layout,
                         const Settings& settings) {
        scenes.push_back({"room/" + name, [=] { return room_scene(layout, settings); }});
    };
    using enum shading::EnvironmentLayout;
    add("latitudes", latitudes, {});
    add("sphere", sphere, {.sides = Sides::one});
    add("cube", cube, {});
    add("shadows", latitudes, {.shadows = Shadows::zfail});
    add("gouraud", latitudes, {.shading = Shading::gouraud});
    add("samples", latitudes, {.grid = 2});
    scenes.push_back({"room/own", [] { return own_room_scene({}); }});
    scenes.push_back(
        {"room/own-shadows", [] { return own_room_scene({.shadows = Shadows::zfail}); }});
    scenes.push_back({"room/refracted", [] { return refracting_scene({}); }});
    scenes.push_back({"room/refracted-one-side",
                      [] { return refracting_scene({.cull = Cull::front, .sides = Sides::one}); }});
    return scenes;
}

NamedScenes glass_scenes() {
    NamedScenes scenes;
    const auto add = [&](const std::string& name, bool glass_first, const Settings& settings) {
        scenes.push_back({"glass/" + name, [=] { return glass_scene(glass_first, settings); }});
    };
    for (const auto& [name, shading] : {std::pair{"flat", Shading::flat},
                                        {"gouraud", Shading::gouraud},
                                        {"phong", Shading::phong}})
        add(name, false, {.shading = shading});
    add("first", true, {});
    add("shadows", false, {.shadows = Shadows::zfail});
    add("flat-shadows", false, {.shading = Shading::flat, .shadows = Shadows::zpass});
    add("gouraud-shadows", false, {.shading = Shading::gouraud, .shadows = Shadows::zfail});
    add("one-sided", false, {.cull = Cull::back, .sides = Sides::one});
    add("samples", false, {.grid = 4});
    add("samples-flat", true, {.shading = Shading::flat, .grid = 2});
    add("samples-shadows", false, {.shadows = Shadows::zfail, .grid = 2});
    add("samples-map", false, {.shadows = Shadows::map, .grid = 2});
    for (const auto shadows : {Shadows::none, Shadows::zfail}) {
        scenes.push_back({shadows == Shadows::none ? "glass/stained" : "glass/stained-shadows",
                          [=] { return stained(glass_scene(true, {.shadows = shadows})); }});
    }
    scenes.push_back({"glass/own", [] { return own_glass_scene({}, Shading::gouraud); }});
    scenes.push_back({"glass/own-shadows",
                      [] { return own_glass_scene({.shadows = Shadows::zfail}, Shading::flat); }});
    return scenes;
}

}  // namespace scanlight::same_bits
