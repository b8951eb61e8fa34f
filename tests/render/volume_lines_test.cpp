// The ghost of a shadow volume.

#include "render/volume_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/build.h"
#include "mesh/shapes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{160, 120};

/// A square under a lamp, seen from the side.
Scene scene_of(const mesh::Mesh& square, const glm::dvec3& lamp) {
    Scene scene;
    scene.objects.push_back({&square, {{}}});
    scene.camera.eye = {0.0, 0.5, 8.0};
    scene.lighting.lights = {shading::point_light<float>(lamp, glm::vec3(1.0f))};
    return scene;
}

TEST(VolumeLines, StayInThePicture) {
    const mesh::Mesh square = mesh::build(mesh::shape("plane:1")).mesh;
    const auto lines = volume_lines(scene_of(square, {0.3, 2.0, 0.2}), {}, 0, 0, size);
    EXPECT_GE(lines.size(), 8u);
    for (const PictureLine& line : lines) {
        for (const glm::dvec2& end : {line.from, line.to}) {
            EXPECT_TRUE(end.x >= 0.0 && end.x <= size.width) << end.x;
            EXPECT_TRUE(end.y >= 0.0 && end.y <= size.height) << end.y;
        }
    }
}

TEST(VolumeLines, RunAwayFromTheLight) {
    const mesh::Mesh square = mesh::build(mesh::shape("plane:1")).mesh;
    const auto lowest = [&](double lamp_y) {
        const auto lines = volume_lines(scene_of(square, {0.0, lamp_y, 0.0}), {}, 0, 0, size);
        double most = 0.0;
        for (const PictureLine& line : lines)
            most = std::max({most, line.from.y, line.to.y});
        return most;
    };
    EXPECT_GT(lowest(2.0), 0.9 * size.height);    // a lamp above: down to the picture's edge
    EXPECT_LT(lowest(-2.0), 0.75 * size.height);  // below: upwards
}

TEST(VolumeLines, AreNoneInTheLampsOwnPlane) {
    const mesh::Mesh square = mesh::build(mesh::shape("plane:1")).mesh;
    EXPECT_TRUE(volume_lines(scene_of(square, {5.0, 0.0, 0.0}), {}, 0, 0, size).empty());
}

}  // namespace
}  // namespace scanlight::render
