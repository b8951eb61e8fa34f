#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

// The pipeline's examples, PIPE.a to PIPE.d: eye (3,4,10), target the origin, up y, fov_y 45
// degrees, aspect 4:3, planes 1 and 100, picture 640x480, point (1,1,0).

Camera example_camera() {
    Camera camera;
    camera.eye = {3.0, 4.0, 10.0};
    camera.magnification = magnification_from_fov(45.0);
    camera.near = 1.0;
    camera.far = 100.0;
    return camera;
}

const glm::dvec4 example_point{1.0, 1.0, 0.0, 1.0};

void expect_near(const glm::dvec3& value, const glm::dvec3& expected, double tolerance) {
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

/// Right-handed, orthonormal, and looking down -z from the eye.
void expect_proper_view(const Camera& camera) {
    const glm::dmat4 view = eye_from_world(camera);
    const glm::dmat3 rotation(view);
    const glm::dmat3 product = rotation * glm::transpose(rotation);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-12) << i << ' ' << j;
    }
    EXPECT_NEAR(glm::determinant(rotation), 1.0, 1e-12);
    expect_near(glm::dvec3(view * glm::dvec4(camera.eye, 1.0)), glm::dvec3(0.0), 1e-9);
}

TEST(Camera, PipeA_EyeSpace) {
    const glm::dvec4 eye = eye_from_world(example_camera()) * example_point;
    expect_near(glm::dvec3(eye), {0.957826285, 0.831004698, -10.5542409}, 1e-7);
    EXPECT_EQ(eye.w, 1.0);
}

TEST(Camera, PipeB_ClipSpace) {
    const Camera camera = example_camera();
    const glm::dvec4 clip =
        clip_from_eye(camera, 4.0 / 3.0) * eye_from_world(camera) * example_point;
    EXPECT_NEAR(clip.x / clip.w, 0.164322373, 1e-9);
    EXPECT_NEAR(clip.y / clip.w, 0.190086889, 1e-9);
    // The example's z runs from -1 to 1, ours from 0 to 1.
    EXPECT_NEAR(2.0 * (clip.z / clip.w) - 1.0, 0.82879062, 1e-8);
}

TEST(Camera, PipeC_Pixel) {
    const glm::dvec3 screen =
        screen_from_world(example_camera(), {640, 480}, glm::dvec3(example_point));
    EXPECT_NEAR(screen.x, 372.583159, 1e-6);
    EXPECT_NEAR(screen.y, 194.379147, 1e-6);
    // The rasterizer's own projection finds it too, to 1/256 pixel.
    Scene scene;
    scene.camera = example_camera();
    const Frame frame = frame_of(scene, Distances::finite, {640, 480});
    const auto snapped =
        raster::snapped<0>(glm::vec4(frame.clip_from_world * example_point), frame.viewport);
    EXPECT_NEAR(snapped.x / 256.0, 372.583159, 0.5 / 256.0 + 1e-4);
    EXPECT_NEAR(snapped.y / 256.0, 194.379147, 0.5 / 256.0 + 1e-4);
}

/// The vertical field of view of a perspective magnification.
double fov_deg_from_magnification(double magnification) {
    return 360.0 / std::numbers::pi * std::atan(1.0 / magnification);
}

TEST(Camera, PipeD_LensToFieldOfView) {
    EXPECT_NEAR(fov_deg_from_magnification(magnification_from_lens(50.0, 24.0)), 26.9914666, 1e-6);
}

TEST(Camera, FieldOfViewGoesThereAndBack) {
    for (const double fov_deg : {1.0, 30.0, 45.0, 90.0, 120.0, 170.0}) {
        EXPECT_NEAR(fov_deg_from_magnification(magnification_from_fov(fov_deg)), fov_deg, 1e-9);
    }
}

TEST(Camera, ClipPlanesBecomeDepthsZeroAndOne) {
    for (const Projection projection : all_projections) {
        Camera camera = example_camera();
        camera.projection = projection;
        const glm::dmat4 clip = clip_from_eye(camera, 1.0);
        const glm::dvec4 near = clip * glm::dvec4(0.0, 0.0, -camera.near, 1.0);
        const glm::dvec4 far = clip * glm::dvec4(0.0, 0.0, -camera.far, 1.0);
        EXPECT_NEAR(near.z / near.w, 0.0, 1e-12);
        EXPECT_NEAR(far.z / far.w, 1.0, 1e-12);
    }
}

TEST(Camera, AnyUpMakesAProperView) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = random.in_cube(5.0);
        camera.target = random.in_cube(5.0);
        camera.up = random.in_cube(2.0);
        expect_proper_view(camera);
    }
}

TEST(Camera, UpAlongTheViewIsReplaced) {
    Random random(2);
    for (int i = 0; i < 50; ++i) {
        Camera camera;
        camera.eye = random.in_cube(5.0);
        camera.target = glm::dvec3(0.0);
        camera.up = camera.eye * (i % 2 == 0 ? 1.0 : -3.0);
        expect_proper_view(camera);
        camera.up = glm::dvec3(0.0);
        expect_proper_view(camera);
    }
    Camera straight_down;
    straight_down.eye = {0.0, 7.0, 0.0};
    expect_proper_view(straight_down);
}

TEST(Camera, UpStaysUpInThePicture) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        Camera camera;
        camera.eye = random.in_cube(5.0);
        camera.up = random.direction();
        const glm::dvec3 up_in_eye_space = glm::dmat3(eye_from_world(camera)) * camera.up;
        EXPECT_NEAR(up_in_eye_space.x, 0.0, 1e-9);
        EXPECT_GT(up_in_eye_space.y, 0.0);
    }
}

TEST(Camera, EyeAtTheTargetLooksDownMinusZ) {
    Camera camera;
    camera.eye = camera.target = {1.0, 2.0, 3.0};
    expect_proper_view(camera);
    expect_near(glm::dvec3(eye_from_world(camera) * glm::dvec4(1.0, 2.0, 0.0, 1.0)),
                {0.0, 0.0, -3.0}, 1e-12);
}

TEST(Camera, OrthographicKeepsSizesAtAnyDistance) {
    Camera camera = example_camera();
    camera.projection = Projection::orthographic;
    camera.magnification = 0.5;  // the picture is 4 units high
    const glm::dmat4 clip = clip_from_eye(camera, 2.0);
    for (const double z : {-1.0, -10.0, -100.0}) {
        const glm::dvec4 p = clip * glm::dvec4(4.0, 2.0, z, 1.0);
        EXPECT_DOUBLE_EQ(p.x, 1.0);
        EXPECT_DOUBLE_EQ(p.y, 1.0);
        EXPECT_EQ(p.w, 1.0);
    }
}

TEST(Camera, ViewpointIsThePlaceOrTheDirectionOfTheEye) {
    Camera camera = example_camera();
    EXPECT_EQ(viewpoint(camera), glm::dvec4(3.0, 4.0, 10.0, 1.0));
    camera.projection = Projection::orthographic;
    const glm::dvec4 direction = viewpoint(camera);
    EXPECT_EQ(direction.w, 0.0);
    expect_near(glm::dvec3(direction), glm::dvec3(3.0, 4.0, 10.0) / std::sqrt(125.0), 1e-15);
}

}  // namespace
}  // namespace scanlight::render
