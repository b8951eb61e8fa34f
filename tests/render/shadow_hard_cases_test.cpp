#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "raster/develop.h"
#include "tests/golden/golden.h"
#include "tests/render/shadow_agreement.h"

namespace scanlight::render {
namespace {

/// Casters over a floor 2 below the origin, under a lamp, seen from the side.
class HardCase : public testing::Test {
protected:
    explicit HardCase() {
        scene_.camera.eye = {5.0, 3.0, 6.0};
        scene_.camera.target = {0.0, -1.0, 0.0};
        scene_.camera.magnification = 1.5;
        put("plane:3", 4.0, {0.0, -2.0, 0.0});
        light({0.5, 4.0, 0.7});
        scene_.lighting.ambient = glm::vec3(0.3f);
        scene_.background = raster::Rgba(0.8f, 0.85f, 0.9f, 1.0f);
    }

    /// Each case is a golden picture, too.
    void TearDown() override {
        Settings settings;
        settings.shadows = Shadows::zfail;
        const Drawing drawing = draw(scene_, settings, {120, 90});
        const auto picture = raster::srgb_image(drawing.framebuffer.color, raster::Alpha::dropped);
        EXPECT_TRUE(golden::matches(golden_name(), picture));
    }

    static std::string golden_name() {
        std::string name = "hard-cases/";
        for (const char c :
             std::string(testing::UnitTest::GetInstance()->current_test_info()->name())) {
            if (std::isupper(static_cast<unsigned char>(c)) && name.back() != '/') name += '-';
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        return name;
    }

    void put(const char* shape, double scale, const glm::dvec3& place) {
        put(std::make_unique<mesh::Mesh>(shape_mesh(shape)), scale, place);
    }
    void put(std::unique_ptr<mesh::Mesh> mesh, double scale, const glm::dvec3& place) {
        Object object{mesh.get(), shading_materials(mesh->materials)};
        for (int k = 0; k < 3; ++k)
            object.world_from_object[k][k] = scale;
        object.world_from_object[3] = glm::dvec4(place, 1.0);
        scene_.objects.push_back(object);
        meshes_.push_back(std::move(mesh));
    }
    void light(const glm::vec3& place) {
        scene_.lighting.lights = {shading::point_light<float>(place, glm::vec3(1.0f))};
    }

    /// By both methods, against the object-space test and against one another.
    void expect_agreement(int shadowed_at_least, double most_y = 1e30) const {
        for (const Shadows method : {Shadows::zpass, Shadows::zfail}) {
            const Agreement result = agreement(scene_, method, 0, {159, 119}, most_y);
            EXPECT_EQ(result.different, 0);
            EXPECT_GE(result.shadowed, shadowed_at_least);
            EXPECT_GT(result.compared, 1000);
        }
        const Drawing drawing = draw_depth(scene_, {}, {159, 119});
        const auto& depth = drawing.framebuffer.depth;
        EXPECT_EQ(difference(counts_of(scene_, Shadows::zpass, 0, depth),
                             counts_of(scene_, Shadows::zfail, 0, depth)),
                  0);
    }

    std::vector<std::unique_ptr<mesh::Mesh>> meshes_;
    Scene scene_;
};

using ShadowHardCase = HardCase;

TEST_F(ShadowHardCase, TheEyeInAShadow) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.eye = {-0.2, -1.2, 0.0};
    scene_.camera.target = {3.0, -2.0, 2.0};
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheNearPlaneCutsAShadow) {
    put("sphere:9,6", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.near = 6.5;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheNearPlaneCutsTheCaster) {
    put("sphere:9,6", 1.0, {0.0, 0.0, 0.0});
    scene_.camera.near = 7.2;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheFarPlaneCutsTheCaster) {
    put("sphere:9,6", 1.0, {0.0, 0.0, 0.0});
    scene_.camera.far = 8.5;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheLightIsInsideTheMesh) {
    put("sphere:9,6", 1.0, {0.0, 1.0, 0.0});
    light({0.1, 1.1, 0.2});
    expect_agreement(4000);  // all is dark
}

TEST_F(ShadowHardCase, TheLightTouchesTheMesh) {
    put("cube", 1.0, {0.0, 0.0, 0.0});
    light({1.0, 1.0, 1.0});  // a corner
    expect_agreement(40);
}

// The face itself lies in the border of a shadow; no light falls on it either way.
TEST_F(ShadowHardCase, TheLightIsInAFacesPlane) {
    put("cube", 1.0, {0.0, 0.0, 0.0});
    light({1.0, 4.0, 0.5});
    expect_agreement(40, -1.9);
}

TEST_F(ShadowHardCase, AnOpenMesh) {
    put("plane:2", 0.8, {0.0, 0.5, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AnOpenMeshSeenFromItsBackByTheLight) {
    put("plane:2", 0.8, {0.0, 0.5, 0.0});
    scene_.objects.back().world_from_object[1][1] = -0.8;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AConcavePolygon) {
    put("star:5", 1.0, {0.0, 0.0, 0.0});
    scene_.objects.back().world_from_object[1] = {0.0, 0.5, 1.0, 0.0};
    expect_agreement(40);
}

// Three leaves on one spine, and one of them twice.
TEST_F(ShadowHardCase, ANonManifoldMesh) {
    mesh::PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0.3f, 0.5f}, {-1, 0.1f, 0.5f}, {0.2f, 1, 0.5f}};
    for (const std::uint32_t leaf : {2u, 3u, 4u, 4u}) {
        for (const std::uint32_t corner : {0u, 1u, leaf})
            soup.corners.push_back({corner});
        soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    put(std::make_unique<mesh::Mesh>(mesh::build(soup, {}).mesh), 1.5, {0.0, 0.0, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AMeshThatShadowsItself) {
    put("torus:13,9", 1.2, {0.0, 0.0, 0.0});
    light({3.0, 1.0, 0.7});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, AMirroredMesh) {
    put("tetrahedron", 1.0, {0.0, 0.0, 0.0});
    scene_.objects.back().world_from_object[0][0] = -1.0;
    put("sphere:6,4", 0.6, {0.3, 0.5, 0.0});
    expect_agreement(40);
}

TEST_F(ShadowHardCase, TheCameraIsFarAway) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.camera.eye *= 300.0;
    scene_.camera.magnification *= 300.0;
    scene_.camera.near = 2400.0;
    scene_.camera.far = 2600.0;
    expect_agreement(40);
}

TEST_F(ShadowHardCase, ThreeHundredVolumesOverOneAnother) {
    for (int i = 0; i < 300; ++i)
        put("plane:1", 0.8, {0.0, 0.003 * i, 0.0});
    const Drawing drawing = draw_depth(scene_, {}, {159, 119});
    const auto& depth = drawing.framebuffer.depth;
    const Counts zfail = counts_of(scene_, Shadows::zfail, 0, depth);
    EXPECT_EQ(*std::ranges::max_element(zfail.values()), 300);
    EXPECT_EQ(difference(zfail, counts_of(scene_, Shadows::zpass, 0, depth)), 0);
}

// ---- the picture

raster::Plane<raster::Rgba> picture(const Scene& scene, const Settings& settings) {
    return draw(scene, settings, {159, 119}).framebuffer.color;
}

TEST_F(ShadowHardCase, ColoursAreThoseOfTheAmbientPictureOrOfTheUnshadowedOne) {
    put("torus:13,9", 1.2, {0.0, 0.0, 0.0});
    scene_.lighting.ambient = glm::vec3(0.2f, 0.25f, 0.3f);
    Scene ambient = scene_;
    ambient.lighting.lights.clear();
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Settings settings;
        settings.shading = shading;
        const auto dark = picture(ambient, settings);
        const auto lit = picture(scene_, settings);
        settings.shadows = Shadows::zfail;
        const auto shadowed = picture(scene_, settings);
        const Drawing drawing = draw_depth(scene_, {}, {159, 119});
        const Counts counts = counts_of(scene_, Shadows::zfail, 0, drawing.framebuffer.depth);
        int in_shadow = 0;
        for_each_pixel({159, 119}, [&](int x, int y) {
            in_shadow += counts.at(x, y) != 0 ? 1 : 0;
            if (counts.at(x, y) != 0) {
                EXPECT_EQ(shadowed.at(x, y), dark.at(x, y));
            } else if (shading != Shading::gouraud) {
                EXPECT_EQ(shadowed.at(x, y), lit.at(x, y));
            } else {  // its intensities are interpolated apart
                EXPECT_NEAR(shadowed.at(x, y).r, lit.at(x, y).r, 1e-6f);
            }
        });
        EXPECT_GT(in_shadow, 1000);
    }
}

TEST_F(ShadowHardCase, EachLightHasShadowsOfItsOwn) {
    put("cube", 0.7, {0.0, 1.0, 0.0});
    scene_.lighting.lights.push_back(
        shading::directional_light<float>({-1.0f, 1.0f, 0.2f}, glm::vec3(0.3f)));
    Settings settings;
    settings.shadows = Shadows::zfail;
    const auto both = picture(scene_, settings);
    Scene first = scene_;
    first.lighting.lights.pop_back();
    Scene second = scene_;
    second.lighting = {glm::vec3(0.0f), {scene_.lighting.lights[1]}};
    second.background = raster::Rgba(0.0f);
    const auto a = picture(first, settings);
    const auto b = picture(second, settings);
    for_each_pixel({159, 119}, [&](int x, int y) {
        EXPECT_EQ(glm::vec3(both.at(x, y)), glm::vec3(a.at(x, y)) + glm::vec3(b.at(x, y)));
    });
}

}  // namespace
}  // namespace scanlight::render
