// Where the plane of a face goes from pixel to pixel.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "render/textured.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr double h = 1.0 / 64;  // of a pixel

/// A plane of an object before a camera.
struct Plane {
    FaceMatrices matrices;
    glm::dvec3 normal;  // object space
    double offset;

    /// The point of the plane, world space, that is seen at a place on the screen.
    glm::dvec3 point_at(const glm::dvec2& place) const {
        return point_behind(matrices.world_from_screen, on_screen(place));
    }
    double inverse_w_at(const glm::dvec2& place) const {
        return 1.0 / point_component(matrices.world_from_screen, 3, on_screen(place));
    }
    /// World space.
    FaceSteps<double> steps() const {
        return face_steps(matrices.object_from_screen, matrices.world_from_screen, normal, offset);
    }
    /// A function's value where the plane is seen, and how it goes on from there.
    double value_at(const glm::dvec4& function, const glm::dvec2& place) const {
        const glm::dvec3 p = point_behind(matrices.object_from_screen, on_screen(place));
        return glm::dot(function, glm::dvec4(p, 1.0));
    }

private:
    glm::dvec3 on_screen(const glm::dvec2& place) const {
        const glm::dvec4 p =
            glm::transpose(glm::dmat4(matrices.object_from_screen)) * glm::dvec4(normal, -offset);
        return {place, -(p.x * place.x + p.y * place.y + p.w) / p.z};
    }
};

Plane random_plane(Random& random) {
    Scene scene;
    scene.camera.eye = glm::dvec3(0.0, 0.0, 6.0) + random.in_cube(1.0);
    scene.camera.target = random.in_cube(0.5);
    scene.camera.near = 1.0;
    scene.camera.far = 20.0;
    Object object;
    const glm::dvec3 axis = random.direction();
    object.world_from_object = glm::rotate(glm::dmat4(1.0), random.between(0.0, 6.0), axis);
    object.world_from_object[0] *= random.between(0.5, 2.0);
    const Frame frame = frame_of(scene, Distances::finite, {200, 100});
    const glm::dvec3 towards_eye = scene.camera.eye + random.in_cube(2.0);
    const glm::dvec3 normal =
        glm::normalize(glm::transpose(glm::dmat3(object.world_from_object)) * towards_eye);
    return {face_matrices(object, frame), normal, random.between(-0.5, 0.5)};
}

/// That `steps` are how `at` changes from pixel to pixel; `off` is relative.
template <class Vector, class At>
void expect_steps(const shading::PixelSteps<Vector>& steps, const At& at, const glm::dvec2& here,
                  double off) {
    const auto check = [&](const Vector& found, const glm::dvec2& way) {
        const Vector moved = (at(here + h * way) - at(here - h * way)) / (2.0 * h);
        EXPECT_LT(glm::length(found - moved), off * glm::length(moved)) << here.x << ' ' << here.y;
    };
    check(steps.right, {1, 0});
    check(steps.down, {0, 1});
}

TEST(FaceSteps, AreHowThePointOfThePlaneMoves) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const Plane plane = random_plane(random);
        const double x = random.between(50, 150);
        const glm::dvec2 here(x, random.between(25, 75));
        const glm::dvec3 point = plane.point_at(here);
        const auto steps = steps_at(plane.steps(), point, plane.inverse_w_at(here));
        expect_steps(
            steps, [&](const glm::dvec2& place) { return plane.point_at(place); }, here, 1e-3);
    }
}

TEST(FaceUvs, GoOnAsUAndVOfThePlaneChange) {
    Random random(7);
    for (int i = 0; i < 500; ++i) {
        const Plane plane = random_plane(random);
        const double x = random.between(50, 150);
        const glm::dvec2 here(x, random.between(25, 75));
        const glm::dvec4 u(random.in_cube(2.0), 0.3);
        const glm::dvec4 v(random.in_cube(2.0), -0.7);
        const auto uv_at = [&](const glm::dvec2& place) {
            return glm::dvec2(plane.value_at(u, place), plane.value_at(v, place));
        };
        const auto of_face = face_uvs(plane.matrices, plane.normal, plane.offset, u, v);
        const auto steps = uv_steps_at(of_face.steps, uv_at(here), plane.inverse_w_at(here));
        expect_steps(steps, uv_at, here, 2e-3);
    }
}

TEST(FaceSteps, AreZeroOfAPlaneSeenEdgeOn) {
    Random random(6);
    Plane plane = random_plane(random);
    plane.normal = glm::dvec3(0.0);
    plane.offset = 0.0;
    const auto steps = plane.steps();
    EXPECT_EQ(steps.right, glm::dvec4(0.0));
    EXPECT_EQ(steps.down, glm::dvec4(0.0));
}

}  // namespace
}  // namespace scanlight::render
