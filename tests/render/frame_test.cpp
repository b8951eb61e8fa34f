#include "render/frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

struct Case {
    Scene scene;
    raster::Viewport size;
};

Case random_case(Random& random, Projection projection) {
    Case c;
    c.size = {1 + random.below(300), 1 + random.below(300)};
    Camera& camera = c.scene.camera;
    camera.projection = projection;
    camera.eye = random.in_cube(10.0);
    camera.target = random.in_cube(10.0);
    camera.magnification = projection == Projection::perspective
                               ? magnification_from_fov(random.between(10.0, 120.0))
                               : random.between(0.1, 3.0);
    camera.near = random.between(0.1, 2.0);
    camera.far = camera.near * random.between(1.5, 100.0);
    return c;
}

/// The point of the world at a pixel's centre and a distance along the view, in double.
glm::dvec3 exact_point(const Case& c, int x, int y, double distance) {
    const Camera& camera = c.scene.camera;
    const double scale =
        (camera.projection == Projection::perspective ? distance : 1.0) / camera.magnification;
    const double aspect = static_cast<double>(c.size.width) / c.size.height;
    const glm::dvec3 eye_space(((x + 0.5) / c.size.width * 2.0 - 1.0) * aspect * scale,
                               (1.0 - (y + 0.5) / c.size.height * 2.0) * scale, -distance);
    return glm::dvec3(glm::inverse(eye_from_world(camera)) * glm::dvec4(eye_space, 1.0));
}

raster::Depth depth_at(const Case& c, const glm::dvec3& point) {
    const double z = screen_from_world(c.scene.camera, c.size, point).z;
    return static_cast<raster::Depth>(std::llrint(z * raster::depth_far));
}

/// By how much a point may be off: single precision in the matrix, and in the depth, of which a
/// distance d on a perspective picture is the d^2 / near fold.
double bound(const Case& c, double distance) {
    const Camera& camera = c.scene.camera;
    const double depth_scale = camera.projection == Projection::perspective
                                   ? distance * distance / camera.near
                                   : camera.far;
    const double widest = distance * 4.0 / std::min(camera.magnification, 1.0);
    return 16.0 * 0x1p-24 * (glm::length(camera.eye) + widest + 4.0 * depth_scale);
}

TEST(Frame, PointAtGivesBackTheWorldPoint) {
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const Case c = random_case(random, all_projections[static_cast<std::size_t>(i % 2)]);
        const Frame frame = frame_of(c.scene, Distances::finite, c.size);
        const int x = random.below(c.size.width);
        const int y = random.below(c.size.height);
        const double distance = random.between(c.scene.camera.near, c.scene.camera.far);
        const glm::dvec3 expected = exact_point(c, x, y, distance);
        const glm::dvec3 found(frame.point_at(x, y, depth_at(c, expected)));
        ASSERT_LT(glm::length(found - expected), bound(c, distance)) << i;
    }
}

TEST(Frame, ViewPointsAtTheEye) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Case c = random_case(random, Projection::perspective);
        const Frame frame = frame_of(c.scene, Distances::finite, c.size);
        const glm::dvec3 point = random.in_cube(10.0);
        const glm::dvec3 expected = glm::normalize(c.scene.camera.eye - point);
        EXPECT_LT(glm::length(glm::dvec3(frame.view_from(point)) - expected), 1e-5);
    }
}

TEST(Frame, ViewAtAPixelIsThatFromWhatItShows) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const Case c = random_case(random, all_projections[static_cast<std::size_t>(i % 2)]);
        const Frame frame = frame_of(c.scene, Distances::finite, c.size);
        const int x = random.below(c.size.width);
        const int y = random.below(c.size.height);
        const double distance = random.between(c.scene.camera.near, c.scene.camera.far);
        const glm::dvec3 point = exact_point(c, x, y, distance);
        const glm::dvec3 expected = frame.is_parallel() ? c.scene.camera.eye - c.scene.camera.target
                                                        : c.scene.camera.eye - point;
        ASSERT_LT(glm::length(glm::dvec3(frame.view_at(x, y)) - glm::normalize(expected)), 1e-6);
    }
}

TEST(Frame, ViewAtAPixelIsADirectionHoweverWideTheCameraSees) {
    Scene scene;
    for (const double magnification : {1e-15, 1.0, 1e15}) {
        scene.camera.magnification = magnification;
        const Frame frame = frame_of(scene, Distances::finite, {16384, 1});
        for (const int x : {0, 8191, 8192, 16383})
            EXPECT_NEAR(glm::length(glm::dvec3(frame.view_at(x, 0))), 1.0, 1e-6) << magnification;
    }
}

TEST(Frame, ViewIsTheSameEverywhereForAParallelCamera) {
    Random random(3);
    const Case c = random_case(random, Projection::orthographic);
    const Frame frame = frame_of(c.scene, Distances::finite, c.size);
    const glm::dvec3 expected = glm::normalize(c.scene.camera.eye - c.scene.camera.target);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 view(frame.view_from(random.in_cube(100.0)));
        EXPECT_LT(glm::length(view - expected), 1e-6);
    }
}

TEST(Frame, AtInfinityEyeAndLampsHaveTheTargetsDirections) {
    Random random(4);
    Case c = random_case(random, Projection::perspective);
    const glm::vec3 lamp(3.0f, 8.0f, -2.0f);
    c.scene.lighting.lights = {shading::point_light<float>(lamp, glm::vec3(0.7f)),
                               white_light({1.0f, 2.0f, 3.0f})};
    const Frame frame = frame_of(c.scene, Distances::infinite, c.size);

    const glm::dvec3 view = glm::normalize(c.scene.camera.eye - c.scene.camera.target);
    const auto& from_lamp = frame.lighting.lights[0];
    EXPECT_EQ(from_lamp.kind, shading::Light<float>::Kind::directional);
    EXPECT_EQ(from_lamp.intensity, glm::vec3(0.7f));
    const glm::dvec3 towards_lamp = glm::normalize(glm::dvec3(lamp) - c.scene.camera.target);
    EXPECT_LT(glm::length(glm::dvec3(from_lamp.place) - towards_lamp), 1e-6);
    EXPECT_EQ(frame.lighting.lights[1].place, c.scene.lighting.lights[1].place);
    for (int i = 0; i < 20; ++i) {
        EXPECT_LT(glm::length(glm::dvec3(frame.view_from(random.in_cube(50.0))) - view), 1e-6);
        const int x = random.below(c.size.width);
        EXPECT_LT(glm::length(glm::dvec3(frame.view_at(x, 3)) - view), 1e-6);
    }
}

}  // namespace
}  // namespace scanlight::render
