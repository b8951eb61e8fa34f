// Where the plane of a face goes from pixel to pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

/// A triangle on a plane, and a texture of so many texels on it.
struct Patch {
    Plane plane;
    FaceUvs<double> uvs;
    glm::dvec4 u, v;
    glm::dvec2 corners[3];  // on the screen
    glm::vec2 texels;
    float uv_unit = 1024.0f;

    glm::dvec2 uv_at(const glm::dvec2& place) const {
        return {plane.value_at(u, place), plane.value_at(v, place)};
    }
    double larger_square_at(const glm::dvec2& place) const {
        const auto steps = uv_steps_at(uvs.steps, uv_at(place), plane.inverse_w_at(place));
        return shading::larger_square(steps, texels);
    }
    bool is_magnified(double near) const {
        MagnifiedFaces<double> face(uvs.steps, texels, uv_precision(uv_unit, {200, 100}));
        for (const glm::dvec2& corner : corners)
            face.add(true, uv_at(corner), plane.inverse_w_at(corner));
        return face.are_sure(static_cast<float>(near));
    }
};

Patch random_patch(Random& random) {
    Patch patch{random_plane(random),
                {},
                glm::dvec4(random.in_cube(2.0), 0.3),
                glm::dvec4(random.in_cube(2.0), -0.7),
                {},
                {}};
    patch.uvs =
        face_uvs(patch.plane.matrices, patch.plane.normal, patch.plane.offset, patch.u, patch.v);
    for (glm::dvec2& corner : patch.corners) {
        const double x = random.between(0, 200);
        corner = {x, random.between(0, 100)};
    }
    const double size = std::exp2(random.between(0, 10));
    patch.texels = {size, size * random.between(0.5, 2.0)};
    return patch;
}

TEST(MagnifiedFaces, HaveNoPixelThatIsLargerThanATexel) {
    Random random(8);
    int magnified = 0;
    int others = 0;
    for (int i = 0; i < 2000; ++i) {
        const Patch patch = random_patch(random);
        double largest = 0;
        for (int k = 0; k < 50; ++k) {
            const double s = random.between(0, 1);
            const double t = random.between(0, 1 - s);
            largest = std::max(largest,
                               patch.larger_square_at(patch.corners[0] * (1 - s - t) +
                                                      patch.corners[1] * s + patch.corners[2] * t));
        }
        if (patch.is_magnified(1.0)) {
            ++magnified;
            ASSERT_LT(largest, 0.8 + 1e-9);
        } else if (largest < 0.25) {
            ++others;  // too careful
        }
    }
    EXPECT_GT(magnified, 300);
    EXPECT_LT(others, 200);
}

TEST(MagnifiedFaces, AreNotThoseOfWhichLittleIsKnown) {
    Random random(9);
    Patch patch = random_patch(random);
    patch.texels = glm::vec2(1e-3f);
    ASSERT_TRUE(patch.is_magnified(1.0));
    EXPECT_FALSE(patch.is_magnified(1e-5));  // so far away that depth hardly tells how far
    patch.uv_unit = 1e15f;                   // of (u, v) that are interpolated so coarsely
    EXPECT_FALSE(patch.is_magnified(1.0));
    patch.uv_unit = 1024.0f;
    patch.u.w = 1e9;
    EXPECT_FALSE(patch.is_magnified(1.0));
    patch.u.w = std::nan("");
    EXPECT_FALSE(patch.is_magnified(1.0));
}

TEST(MagnifiedFaces, AreThoseOfTiledTexturesToo) {
    Random random(11);
    const Patch patch = random_patch(random);
    const auto is_sure = [&](double u, int width) {
        MagnifiedFaces<double> face(patch.uvs.steps, glm::vec2(1e-3f),
                                    uv_precision(1.0f, {width, width}));
        face.add(true, glm::dvec2(u, 0.5), 5.0);
        return face.are_sure(1.0f);
    };
    EXPECT_TRUE(is_sure(3.0, 16384));
    EXPECT_FALSE(is_sure(4.5, 16384));  // cut off at the pixel
}

TEST(MagnifiedFaces, AreNotThoseThatReachBehindTheEye) {
    Random random(10);
    const Patch patch = random_patch(random);
    MagnifiedFaces<double> face(patch.uvs.steps, glm::vec2(1e-3f), uv_precision(1.0f, {200, 100}));
    face.add(true, glm::dvec2(0.1, 0.2), 5.0);
    face.add(false, glm::dvec2(0.1, 0.2), -1.0);  // no corner of it
    EXPECT_TRUE(face.are_sure(1.0f));
    face.add(true, glm::dvec2(0.1, 0.2), -1.0);
    EXPECT_FALSE(face.are_sure(1.0f));
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
