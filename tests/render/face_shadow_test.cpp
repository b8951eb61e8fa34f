#include "render/face_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scanlight::render {
namespace {

using Polygon = FaceShadow::Polygon;

const glm::dvec4 light(0.0, 10.0, 0.0, 1.0);

Polygon square(double half_side, double y) {
    return {{-half_side, y, -half_side},
            {half_side, y, -half_side},
            {half_side, y, half_side},
            {-half_side, y, half_side}};
}

double area(const Polygon& polygon) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * std::sqrt(glm::dot(sum, sum));
}

// SHAD.a and SHAD.b: the square's shadow on the floor reaches to (2, 0, 2), 16 of 100.
TEST(FaceShadow, CutsTheChaptersFloor) {
    const auto [shadowed, lit] = FaceShadow(square(1.0, 5.0), light).cut(square(5.0, 0.0));
    double lit_area = 0.0;
    for (const Polygon& part : lit)
        lit_area += area(part);
    EXPECT_NEAR(area(shadowed), 16.0, 1e-12);
    EXPECT_NEAR(lit_area, 84.0, 1e-12);
    for (const glm::dvec3& corner : shadowed) {
        EXPECT_NEAR(std::abs(corner.x), 2.0, 1e-12);
        EXPECT_NEAR(corner.y, 0.0, 1e-12);
        EXPECT_NEAR(std::abs(corner.z), 2.0, 1e-12);
    }
}

// SHAD.d: the corner (.5, 5, -1) throws its shadow on the wall z = -3 at (1.5, -5, -3).
TEST(FaceShadow, CutsTheChaptersWall) {
    const Polygon face{{-0.5, 5, -1}, {0.5, 5, -1}, {0.5, 5, 1}, {-0.5, 5, 1}};
    const Polygon wall{{-20, -20, -3}, {20, -20, -3}, {20, 20, -3}, {-20, 20, -3}};
    const Polygon shadowed = FaceShadow(face, light).cut(wall).shadowed;
    const glm::dvec3 expected(1.5, -5.0, -3.0);
    EXPECT_TRUE(std::ranges::any_of(shadowed, [&](const glm::dvec3& corner) {
        const glm::dvec3 off = corner - expected;
        return glm::dot(off, off) < 1e-20;
    }));
}

// SHAD.c
TEST(FaceShadow, HoldsTheChaptersPoint) {
    const FaceShadow shadow(square(1.0, 5.0), light);
    EXPECT_TRUE(shadow.contains({1.5, 0.0, 0.0}, 1e-9));
    EXPECT_FALSE(shadow.contains({2.5, 0.0, 0.0}, 1e-9));
    EXPECT_FALSE(shadow.contains({0.0, 7.0, 0.0}, 1e-9));
    EXPECT_FALSE(shadow.contains({1.1, 4.6, 0.0}, 1e-9));
}

TEST(FaceShadow, DoesNotHoldItsOwnFace) {
    EXPECT_FALSE(FaceShadow(square(1.0, 5.0), light).contains({0.5, 5.0, 0.5}, 1e-9));
}

TEST(FaceShadow, IsTheSameForAFaceTurnedRound) {
    Polygon turned = square(1.0, 5.0);
    std::reverse(turned.begin(), turned.end());
    EXPECT_TRUE(FaceShadow(turned, light).contains({1.5, 0.0, 0.0}, 1e-9));
    EXPECT_FALSE(FaceShadow(turned, light).contains({2.5, 0.0, 0.0}, 1e-9));
}

TEST(FaceShadow, IsEmptyWithTheLightInTheFacesPlane) {
    const FaceShadow shadow(square(1.0, 5.0), {20.0, 5.0, 0.0, 1.0});
    EXPECT_TRUE(shadow.empty());
    EXPECT_FALSE(shadow.contains({-10.0, 5.0, 0.0}, 0.0));
    EXPECT_NEAR(area(shadow.cut(square(5.0, 0.0)).lit.front()), 100.0, 1e-12);
}

TEST(FaceShadow, OfADirectionalLightIsAPrism) {
    const FaceShadow shadow(square(1.0, 5.0), {0.0, 1.0, 0.0, 0.0});
    EXPECT_NEAR(area(shadow.cut(square(5.0, 0.0)).shadowed), 4.0, 1e-12);
}

}  // namespace
}  // namespace scanlight::render
