// Laws of the light in whole pictures (specification 12.1.2).
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

using Picture = raster::Plane<raster::Rgba>;

constexpr raster::Viewport size{64, 48};

Picture picture_under(Scene scene, const std::vector<shading::Light<float>>& lights,
                      const Settings& settings) {
    scene.lighting.lights = lights;
    return draw(scene, settings, size).framebuffer.color;
}

// C12.1.2-MULTI
TEST(LightLaws, TwoLightsAddUp) {
    const auto mesh = shape_mesh("torus:10,6");
    Scene scene = scene_of(mesh, {{30.0, 40.0}, size});
    scene.objects.front().materials.front().facets.share = 0.5;
    scene.objects.front().materials.front().transmission.diffuse = glm::vec3(0.3f);
    const auto a = white_light({1.0f, 2.0f, 3.0f});
    const auto b = shading::point_light<float>({-2.0f, 1.0f, 0.5f}, {0.2f, 0.3f, 0.6f},
                                               {shading::Falloff::inverse, 1.0f});
    for (const Shading shading : all_shadings) {
        for (const auto illumination :
             {shading::Illumination::lambert, shading::Illumination::gouraud71,
              shading::Illumination::phong, shading::Illumination::blinn,
              shading::Illumination::hall, shading::Illumination::cook_torrance}) {
            Settings settings;
            settings.shading = shading;
            settings.illumination = illumination;
            const Picture both = picture_under(scene, {a, b}, settings);
            const Picture first = picture_under(scene, {a}, settings);
            const Picture second = picture_under(scene, {b}, settings);
            const Picture none = picture_under(scene, {}, settings);
            for_each_pixel(size, [&](int x, int y) {
                const auto sum = first.at(x, y) + second.at(x, y) - none.at(x, y);
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(both.at(x, y)[k], sum[k], 2e-6) << x << ' ' << y;
            });
        }
    }
}

// C12.1.2-AMBIENT
TEST(LightLaws, UnderAmbientLightASphereIsAUniformDisc) {
    const auto mesh = shape_mesh("sphere:24,12");
    const Scene scene = scene_of(mesh, {{30.0, 20.0}, size});
    const glm::vec3 expected = scene.lighting.ambient * plastic().ambient;
    for (const Shading shading : all_shadings) {
        Settings settings;
        settings.shading = shading;
        const Picture picture = picture_under(scene, {}, settings);
        std::size_t drawn = 0;
        for (const raster::Rgba& color : picture.values()) {
            if (color.a == 0.0f) continue;
            ++drawn;
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(color[k], expected[k], 1e-7);
        }
        EXPECT_GT(drawn, 1000u);
    }
}

/// A pane with its back to the light.
Scene pane_before_a_lamp(const mesh::Mesh& pane) {
    Scene scene = scene_of(pane, {{0.0, 90.0}, size});  // from above
    scene.lighting = {glm::vec3(0.1f), {white_light({0.1f, -1.0f, 0.2f})}};
    scene.objects.front().materials.front().transmission = {glm::vec3(0.5f), glm::vec3(0.4f), 50};
    return scene;
}

// C12.3.3-HALL
TEST(LightLaws, ALampBehindAPaneIsSeenByHallOnly) {
    const auto mesh = shape_mesh("plane:1");
    const Scene scene = pane_before_a_lamp(mesh);
    const glm::vec3 ambient = scene.lighting.ambient * plastic().ambient;
    for (const Shading shading : all_shadings) {
        Settings settings;
        settings.shading = shading;
        settings.illumination = shading::Illumination::blinn;
        const raster::Rgba dark = draw(scene, settings, size).framebuffer.color.at(32, 24);
        EXPECT_NEAR(dark.r, ambient.r, 1e-7);
        settings.illumination = shading::Illumination::hall;
        const raster::Rgba bright = draw(scene, settings, size).framebuffer.color.at(32, 24);
        EXPECT_GT(bright.r, ambient.r + 0.9f * 0.4f);
    }
}

using ColorOfFace = std::map<std::uint32_t, std::set<std::array<float, 3>>>;

ColorOfFace colors_by_face(const Scene& scene, const Settings& settings) {
    const Picture picture = draw(scene, settings, size).framebuffer.color;
    const auto ids = draw_ids(scene, settings, size);
    ColorOfFace colors;
    for_each_pixel(size, [&](int x, int y) {
        const auto& c = picture.at(x, y);
        if (ids.at(x, y) != 0) colors[ids.at(x, y)].insert({c.r, c.g, c.b});
    });
    return colors;
}

Settings flat_lambert() {
    Settings settings;
    settings.shading = Shading::flat;
    settings.illumination = shading::Illumination::lambert;
    settings.cull = Cull::back;
    return settings;
}

Scene lamp_lit_scene(const mesh::Mesh& mesh, const ViewAngles& angles) {
    Scene scene = scene_of(mesh, {angles, size});
    scene.lighting.lights = {white_light({1.0f, 2.0f, 0.5f}),
                             shading::point_light<float>({0.5f, 3.0f, 2.0f}, glm::vec3(0.4f))};
    return scene;
}

// C12.1.3-FLAT
TEST(LightLaws, FlatShadingHasOneColorAFacet) {
    const auto mesh = shape_mesh("torus:10,6");
    for (const auto illumination : {shading::Illumination::lambert, shading::Illumination::phong}) {
        Settings settings = flat_lambert();
        settings.illumination = illumination;
        const auto colors = colors_by_face(lamp_lit_scene(mesh, {30.0, 50.0}), settings);
        std::set<std::array<float, 3>> distinct;
        for (const auto& [face, of_face] : colors) {
            EXPECT_EQ(of_face.size(), 1u) << "face " << face;
            distinct.insert(of_face.begin(), of_face.end());
        }
        EXPECT_GT(colors.size(), 25u);
        EXPECT_GT(distinct.size(), colors.size() / 2);
    }
}

// C12.1-WYLIE: along a floor under a lamp, I_p K_d (N.L) times the law's share of the distance.
TEST(LightLaws, AFloorDarkensByTheChosenLaw) {
    using shading::Falloff;
    const auto share = [](Falloff law, double r) {
        switch (law) {
            case Falloff::inverse:
                return 1.0 / r;
            case Falloff::inverse_square:
                return 1.0 / (r * r);
            case Falloff::inverse_plus_k:
                return 1.0 / (r + 0.75);
            default:
                return 1.0;
        }
    };
    const auto mesh = shape_mesh("plane:1");
    const glm::dvec3 lamp(-0.6, 0.5, 0.1);
    Settings settings;
    settings.illumination = shading::Illumination::lambert;
    for (const Falloff law :
         {Falloff::constant, Falloff::inverse, Falloff::inverse_square, Falloff::inverse_plus_k}) {
        Scene scene = scene_of(mesh, {{20.0, 35.0}, size});
        scene.lighting = {glm::vec3(0.0f),
                          {shading::point_light<float>(lamp, glm::vec3(1.0f), {law, 0.75f})}};
        const Drawing drawing = draw(scene, settings, size);
        const Frame frame = frame_of(scene, Distances::finite, size);
        std::size_t compared = 0;
        for_each_pixel(size, [&](int x, int y) {
            const auto depth = drawing.framebuffer.depth.at(x, y);
            if (depth == raster::depth_clear) return;
            const glm::dvec3 to_lamp = lamp - glm::dvec3(frame.point_at(x, y, depth));
            const double r = glm::length(to_lamp);
            const double expected = 0.5 * (to_lamp.y / r) * share(law, r);
            ASSERT_NEAR(drawing.framebuffer.color.at(x, y).r, expected, 1e-3 * expected);
            ++compared;
        });
        EXPECT_GT(compared, 500u);
    }
}

// 12.1.2 LAMBERT: independent of V. The same facet has the same bits from wherever it is seen.
TEST(LightLaws, LambertIsUnchangedByTheEyesMotion) {
    const auto mesh = shape_mesh("torus:10,6");
    const auto here = colors_by_face(lamp_lit_scene(mesh, {30.0, 50.0}), flat_lambert());
    const auto there = colors_by_face(lamp_lit_scene(mesh, {100.0, 20.0}), flat_lambert());
    std::size_t shared = 0;
    for (const auto& [face, colors] : here) {
        const auto found = there.find(face);
        if (found == there.end()) continue;
        ++shared;
        EXPECT_EQ(found->second, colors) << "face " << face;
    }
    EXPECT_GT(shared, 10u);
}

TEST(LightLaws, AHighlightMovesWithTheEye) {
    const auto mesh = shape_mesh("torus:10,6");
    Settings settings = flat_lambert();
    settings.illumination = shading::Illumination::phong;
    EXPECT_NE(colors_by_face(lamp_lit_scene(mesh, {30.0, 50.0}), settings),
              colors_by_face(lamp_lit_scene(mesh, {32.0, 50.0}), settings));
}

// 12.1.2 LAMBERT at each pixel of a smooth floor, from two eyes: K_d I_p (N.L), L at that point.
TEST(LightLaws, LambertAtAPixelIsThatOfItsPoint) {
    const auto mesh = shape_mesh("plane:1");
    const glm::dvec3 lamp(0.3, 0.8, -0.2);
    for (const ViewAngles angles : {ViewAngles{20.0, 35.0}, ViewAngles{200.0, 70.0}}) {
        Scene scene = scene_of(mesh, {angles, size});
        scene.lighting.lights = {shading::point_light<float>(lamp, glm::vec3(0.9f))};
        Settings settings;
        settings.illumination = shading::Illumination::lambert;
        const Drawing drawing = draw(scene, settings, size);
        const Frame frame = frame_of(scene, Distances::finite, size);
        for_each_pixel(size, [&](int x, int y) {
            const auto depth = drawing.framebuffer.depth.at(x, y);
            if (depth == raster::depth_clear) return;
            const glm::dvec3 point(frame.point_at(x, y, depth));
            ASSERT_NEAR(point.y, 0.0, 1e-4);
            const double cosine = glm::normalize(lamp - point).y;
            const double expected = 0.1 * 0.5 + 0.9 * 0.5 * cosine;  // the red channel
            ASSERT_NEAR(drawing.framebuffer.color.at(x, y).r, expected, 1e-4);
        });
    }
}

TEST(LightLaws, AtInfinityAFloorIsOneColor) {
    const auto mesh = shape_mesh("plane:4");
    Scene scene = scene_of(mesh, {{20.0, 35.0}, size});
    scene.lighting.lights = {shading::point_light<float>({0.5f, 0.8f, 0.5f}, glm::vec3(0.9f))};
    const auto distinct_reds = [&](Distances distances, shading::Illumination illumination) {
        Settings settings;
        settings.distances = distances;
        settings.illumination = illumination;
        std::set<float> reds;
        const Picture picture = draw(scene, settings, size).framebuffer.color;
        for (const auto& color : picture.values())
            reds.insert(color.r);
        return reds.size();
    };
    for (const auto model : {shading::Illumination::phong, shading::Illumination::blinn}) {
        EXPECT_GT(distinct_reds(Distances::finite, model), 100u);
        EXPECT_LE(distinct_reds(Distances::infinite, model), 4u);  // the background, and rounding
    }
}

}  // namespace
}  // namespace scanlight::render
