#include "shading/vector.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

const Vec3<float> fallback{0, 0, 1};

TEST(PositivePart, OfNegativeNumbersAndNanIsZero) {
    EXPECT_EQ(positive_part(-1.0f), 0.0f);
    EXPECT_EQ(positive_part(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_EQ(positive_part(0.25f), 0.25f);
}

TEST(Unit, HasLengthOneAndTheSameDirection) {
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const Vec3<double> direction = random.unit_vector();
        const double length = random.between(0.001, 1000);
        const Vec3<double> u = unit(direction * length);
        ASSERT_NEAR(dot(u, direction), 1, 1e-14);
        ASSERT_NEAR(dot(u, u), 1, 1e-14);
    }
}

TEST(UnitOr, TakesTheFallbackWhereThereIsNoDirection) {
    EXPECT_EQ(unit_or(Vec3<float>(0), fallback), fallback);
    EXPECT_EQ(unit_or(Vec3<float>(0x1p-61f, 0, 0), fallback), fallback);
    EXPECT_EQ(unit_or(Vec3<float>(0x1p61f, 0, 0), fallback), fallback);
    EXPECT_EQ(unit_or(Vec3<float>(std::numeric_limits<float>::infinity(), 0, 0), fallback),
              fallback);
    EXPECT_EQ(unit_or(Vec3<float>(std::numeric_limits<float>::quiet_NaN(), 0, 0), fallback),
              fallback);
}

TEST(UnitOr, IsUnitUpToTheStatedLengths) {
    const Vec3<float> x_axis(1, 0, 0);
    EXPECT_EQ(unit_or(Vec3<float>(0x1p-60f, 0, 0), fallback), x_axis);
    EXPECT_EQ(unit_or(Vec3<float>(0x1p60f, 0, 0), fallback), x_axis);
}

}  // namespace
}  // namespace scanlight::shading
