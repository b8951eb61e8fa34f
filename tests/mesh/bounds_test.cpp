#include "mesh/bounds.h"

#include <gtest/gtest.h>

#include "mesh/build.h"
#include "mesh/shapes.h"
#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

TEST(Bounds, OfNothingAreAPointAtTheOrigin) {
    EXPECT_EQ(bounding_box(Mesh{}).size(), glm::dvec3(0.0));
    EXPECT_EQ(bounding_ball(Mesh{}).radius, 0.0);
}

TEST(Bounds, OfACube) {
    const Mesh mesh = build(shape("cube")).mesh;
    const Box box = bounding_box(mesh);
    EXPECT_EQ(box.low, glm::dvec3(-1.0));
    EXPECT_EQ(box.high, glm::dvec3(1.0));
    EXPECT_DOUBLE_EQ(bounding_ball(mesh).radius, std::sqrt(3.0));
    EXPECT_EQ(bounding_ball(mesh).center, glm::dvec3(0.0));
}

TEST(Bounds, LeaveOutPointsThatNothingUses) {
    const Mesh mesh =
        build(soup_of({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {99, 99, 99}}, {{0, 1, 2}})).mesh;
    EXPECT_EQ(bounding_box(mesh).high, glm::dvec3(2, 4, 0));
    EXPECT_EQ(bounding_ball(mesh).center, glm::dvec3(1, 2, 0));
}

TEST(Bounds, OfTheLargestFloatsAreFinite) {
    const Mesh mesh = build(scaled(shape("cube"), 3.4e38f)).mesh;
    EXPECT_NEAR(bounding_box(mesh).size().x / 6.8e38, 1.0, 1e-6);
    EXPECT_TRUE(std::isfinite(bounding_ball(mesh).radius));
}

}  // namespace
}  // namespace scanlight::mesh
