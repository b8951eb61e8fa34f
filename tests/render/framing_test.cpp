#include "render/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr double margin = 1.06;  // from the objects to the picture's border

/// How far the objects reach in the picture: 1 is its border; and their depths.
struct Reach {
    double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
    double nearest = 1e9, farthest = -1e9;

    double widest() const { return std::max({-left, right, -bottom, top}); }
};

Reach reach_of(const Camera& camera, const std::vector<Object>& objects, double aspect) {
    const glm::dmat4 clip = clip_from_eye(camera, aspect) * eye_from_world(camera);
    Reach reach;
    for (const Object& object : objects) {
        const auto& vertices = object.mesh->vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const glm::dvec4 p =
                clip * object.world_from_object * glm::dvec4(glm::dvec3(vertices.position(i)), 1.0);
            EXPECT_GT(p.w, 0.0) << "behind the eye";
            const glm::dvec3 ndc = glm::dvec3(p) / p.w;
            reach.left = std::min(reach.left, ndc.x);
            reach.right = std::max(reach.right, ndc.x);
            reach.bottom = std::min(reach.bottom, ndc.y);
            reach.top = std::max(reach.top, ndc.y);
            reach.nearest = std::min(reach.nearest, ndc.z);
            reach.farthest = std::max(reach.farthest, ndc.z);
        }
    }
    return reach;
}

void expect_inside_planes(const Reach& reach) {
    EXPECT_GE(reach.nearest, 0.0);
    EXPECT_LE(reach.farthest, 1.0);
}

void expect_framed(const Camera& camera, const std::vector<Object>& objects, double aspect) {
    const Reach reach = reach_of(camera, objects, aspect);
    EXPECT_NEAR(reach.widest(), 1.0 / margin, 1e-6);
    // Centred: the opposite sides of the picture are as close.
    EXPECT_NEAR(reach.left + reach.right, 0.0, 1e-6);
    EXPECT_NEAR(reach.bottom + reach.top, 0.0, 1e-6);
    expect_inside_planes(reach);
}

/// Never so long a shape that its tip alone says how near the camera may come.
std::vector<glm::dvec3> random_points(Random& random, double size) {
    const glm::dvec3 stretch = glm::dvec3(0.7) + glm::abs(random.in_cube(0.5));
    std::vector<glm::dvec3> points;
    const int count = 6 + random.below(20);
    for (int i = 0; i < count; ++i)
        points.push_back(size * stretch * random.in_cube(1.0));
    return points;
}

Camera random_camera(Random& random, Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.eye = random.direction();
    camera.magnification = magnification_from_fov(random.between(10.0, 60.0));
    return camera;
}

TEST(Framing, FillsThePictureUpToTheMargin) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Projection projection = all_projections[static_cast<std::size_t>(i % 2)];
        const auto mesh = points_mesh(random_points(random, 1.0));
        const double aspect = std::pow(4.0, random.between(-1.0, 1.0));
        const std::vector<Object> objects{{&mesh, {}}};
        SCOPED_TRACE(i);
        expect_framed(framed(random_camera(random, projection), objects, aspect), objects, aspect);
    }
}

TEST(Framing, KeepsDirectionFieldOfViewAndProjection) {
    const auto mesh = shape_mesh("teapot:3");
    const std::vector<Object> objects{object_of(mesh)};
    Random random(2);
    for (int i = 0; i < 50; ++i) {
        const Camera before = random_camera(random, Projection::perspective);
        const Camera after = framed(before, objects, 1.5);
        EXPECT_EQ(after.magnification, before.magnification);
        EXPECT_EQ(after.projection, before.projection);
        const glm::dvec3 direction = glm::normalize(after.eye - after.target);
        EXPECT_LT(glm::length(direction - before.eye), 1e-9);
    }
}

TEST(Framing, TakesSeveralPlacedObjectsTogether) {
    const auto cube = shape_mesh("cube");
    Object left = object_of(cube);
    Object right = object_of(cube);
    left.world_from_object[3] = glm::dvec4(-5.0, 1.0, 0.0, 1.0);
    right.world_from_object[3] = glm::dvec4(5.0, 0.0, -3.0, 1.0);
    const std::vector<Object> objects{left, right};
    for (const Projection projection : all_projections) {
        Camera camera;
        camera.projection = projection;
        expect_framed(framed(camera, objects, 4.0), objects, 4.0);
    }
}

TEST(Framing, HugeAndTinyMeshesLookLikeOthers) {
    for (const double size : {1e-18, 1e-6, 1e6, 1e18}) {
        Random random(3);
        for (int i = 0; i < 20; ++i) {
            const Projection projection = all_projections[static_cast<std::size_t>(i % 2)];
            const auto mesh = points_mesh(random_points(random, size));
            const std::vector<Object> objects{{&mesh, {}}};
            SCOPED_TRACE(size);
            expect_framed(framed(random_camera(random, projection), objects, 1.0), objects, 1.0);
        }
    }
}

TEST(Framing, HugeAndTinyMeshesAreDrawn) {
    for (const double size : {1e-18, 1e18}) {
        const auto mesh = shape_mesh("cube");
        for (const Projection projection : all_projections) {
            Object small = object_of(mesh);
            small.world_from_object = glm::dmat4(size);
            small.world_from_object[3][3] = 1.0;
            const Scene scene = scene_of(std::vector{small}, {{}, {32, 32}, projection});
            const Scene usual = scene_of(mesh, {{}, {32, 32}, projection});
            EXPECT_EQ(covered_pixels(draw(scene, {}, {32, 32}).framebuffer.depth),
                      covered_pixels(draw(usual, {}, {32, 32}).framebuffer.depth));
        }
    }
}

TEST(Framing, ASinglePointStandsInTheMiddle) {
    for (const glm::dvec3& point : {glm::dvec3(0.0), glm::dvec3(1.0, 2.0, 3.0)}) {
        const auto mesh = points_mesh({point});
        const std::vector<Object> objects{{&mesh, {}}};
        for (const Projection projection : all_projections) {
            Camera camera;
            camera.projection = projection;
            const Reach reach = reach_of(framed(camera, objects, 1.0), objects, 1.0);
            EXPECT_NEAR(reach.left, 0.0, 1e-6);
            EXPECT_NEAR(reach.top, 0.0, 1e-6);
            expect_inside_planes(reach);
        }
    }
}

TEST(Framing, ASpikeTowardsTheEyeStaysBeforeIt) {
    const auto mesh = points_mesh({{0, 0, 100}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
    const std::vector<Object> objects{{&mesh, {}}};
    const Camera camera = framed({}, objects, 1.0);  // looks down -z, at the tip
    EXPECT_GT(camera.eye.z, 100.0 + 0.05);
    EXPECT_LT(camera.eye.z, 110.0);
    const Reach reach = reach_of(camera, objects, 1.0);
    EXPECT_LE(reach.widest(), 1.0 / margin + 1e-9);
    expect_inside_planes(reach);
}

TEST(Framing, EyeAtTheTargetLooksFromPlusZ) {
    const auto mesh = shape_mesh("cube");
    const std::vector<Object> objects{object_of(mesh)};
    for (const Projection projection : all_projections) {
        Camera camera;
        camera.projection = projection;
        camera.eye = camera.target = glm::dvec3(7.0);
        const Camera result = framed(camera, objects, 1.0);
        EXPECT_GT(result.eye.z, 1.0);
        expect_framed(result, objects, 1.0);
    }
}

TEST(Framing, NothingToSeeLeavesTheCamera) {
    const mesh::Mesh empty;
    Camera camera;
    camera.eye = {3.0, 2.0, 1.0};
    const Camera result = framed(camera, {{&empty, {}}}, 1.0);
    EXPECT_EQ(result.eye, camera.eye);
    EXPECT_EQ(result.target, camera.target);
    EXPECT_EQ(result.near, camera.near);
    EXPECT_EQ(result.far, camera.far);
    EXPECT_EQ(framed(camera, {}, 1.0).eye, camera.eye);
}

TEST(Framing, DirectionsOfAngles) {
    const auto expect_direction = [](const ViewAngles& angles, const glm::dvec3& expected) {
        EXPECT_LT(glm::length(direction_of(angles) - expected), 1e-12);
    };
    expect_direction({0.0, 0.0}, {0.0, 0.0, 1.0});
    expect_direction({90.0, 0.0}, {1.0, 0.0, 0.0});
    expect_direction({180.0, 0.0}, {0.0, 0.0, -1.0});
    expect_direction({-90.0, 0.0}, {-1.0, 0.0, 0.0});
    expect_direction({123.0, 90.0}, {0.0, 1.0, 0.0});
    expect_direction({0.0, -90.0}, {0.0, -1.0, 0.0});
    expect_direction({45.0, 30.0}, {std::sqrt(0.375), 0.5, std::sqrt(0.375)});
}

TEST(FittedPlanes, FromInsideKeepTheirRatio) {
    const auto mesh = shape_mesh("icosphere:2");
    const std::vector<Object> objects{object_of(mesh)};
    Camera camera;
    camera.eye = {0.0, 0.0, 0.5};
    camera.target = {0.0, 0.0, -1.0};
    const Camera result = with_fitted_planes(camera, objects);
    EXPECT_NEAR(result.far, 1.5, 0.01);
    EXPECT_DOUBLE_EQ(result.near, 1e-4 * result.far);
    EXPECT_EQ(result.eye, camera.eye);
}

TEST(FittedPlanes, StayWhenAllIsBehindTheEye) {
    const auto mesh = shape_mesh("cube");
    Camera camera;
    camera.eye = {0.0, 0.0, 10.0};
    camera.target = {0.0, 0.0, 20.0};
    const Camera result = with_fitted_planes(camera, {object_of(mesh)});
    EXPECT_EQ(result.near, camera.near);
    EXPECT_EQ(result.far, camera.far);
}

}  // namespace
}  // namespace scanlight::render
