#include "render/light_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

std::vector<Object> some_objects(const mesh::Mesh& mesh) {
    std::vector<Object> objects{object_of(mesh), object_of(mesh)};
    objects[1].world_from_object[3] = glm::dvec4(2.0, -3.0, 1.0, 1.0);
    return objects;
}

bool is_in_picture(const glm::dvec3& place) {
    constexpr double rounding = 1e-12;
    return std::abs(place.x) <= 1.0 + rounding && std::abs(place.y) <= 1.0 + rounding;
}

TEST(LightView, ThatOfADirectionalLightShowsAllObjects) {
    const mesh::Mesh mesh = shape_mesh("sphere:12,6");
    const auto objects = some_objects(mesh);
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const auto cameras = light_cameras(glm::dvec4(random.direction(), 0.0), objects);
        ASSERT_EQ(cameras.size(), 1u);
        const LightView view(cameras.front());
        for (const Object& object : objects) {
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
                const glm::dvec3 place =
                    view.seen(glm::dvec3(object.world_from_object *
                                         glm::dvec4(glm::dvec3(mesh.vertices.position(v)), 1.0)));
                EXPECT_TRUE(is_in_picture(place));
                EXPECT_GT(place.z, cameras.front().near);
                EXPECT_LT(place.z, cameras.front().far);
            }
        }
    }
}

TEST(LightView, OneFaceOfTheCubeShowsWhateverThereIs) {
    const mesh::Mesh mesh = shape_mesh("cube");
    const glm::dvec3 light(0.3, -0.2, 0.4);
    const auto cameras = light_cameras(glm::dvec4(light, 1.0), some_objects(mesh));
    ASSERT_EQ(cameras.size(), 6u);
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const double distance = random.between(0.01, 5.0);
        const glm::dvec3 from_light = distance * random.direction();
        const LightView view(cameras[cube_face(from_light)]);
        const glm::dvec3 place = view.seen(light + from_light);
        EXPECT_TRUE(is_in_picture(place));
        EXPECT_GT(place.z, 0.0);
    }
}

TEST(LightView, ARayGoesThroughThePointsThatAreSeenThere) {
    const mesh::Mesh mesh = shape_mesh("cube");
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const double w = i % 2;
        const auto cameras = light_cameras(glm::dvec4(random.direction(), w), some_objects(mesh));
        const LightView view(
            cameras[static_cast<std::size_t>(random.below(static_cast<int>(cameras.size())))]);
        const double x = random.between(-1.0, 1.0);
        const auto [origin, direction] = view.ray(x, 0.25);
        const glm::dvec3 place = view.seen(origin + 3.0 * direction);
        EXPECT_NEAR(place.x, x, 1e-12);
        EXPECT_NEAR(place.y, 0.25, 1e-12);
        EXPECT_NEAR(place.z, 3.0, 1e-12);
    }
}

}  // namespace
}  // namespace scanlight::render
