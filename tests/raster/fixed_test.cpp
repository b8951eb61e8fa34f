#include "raster/fixed.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/raster/cases.h"

namespace scanlight::raster {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Fixed, DivisionRoundsDownOnBothSidesOfZero) {
    const auto expect_quotient = [](const Quotient& q, int whole, int remainder) {
        EXPECT_EQ(q.whole, whole);
        EXPECT_EQ(q.remainder, remainder);
    };
    expect_quotient(floor_divided(7, 2), 3, 1);
    expect_quotient(floor_divided(-7, 2), -4, 1);
    expect_quotient(floor_divided(-8, 2), -4, 0);
    expect_quotient(floor_divided(std::int64_t{-1} << 40, 1 << 30), -1024, 0);
    expect_quotient(floor_divided((std::int64_t{-1} << 40) - 1, 1 << 30), -1025, (1 << 30) - 1);
}

TEST(Fixed, FirstCentreIncludesACentreAndExcludesAllBeforeIt) {
    EXPECT_EQ(first_centre(0), 0);
    EXPECT_EQ(first_centre(128), 0);
    EXPECT_EQ(first_centre(129), 1);
    EXPECT_EQ(first_centre(384), 1);
    EXPECT_EQ(first_centre(max_size * subpixels), max_size);
    EXPECT_EQ(first_centre(-128), -1);
    EXPECT_EQ(first_centre(-127), 0);
}

TEST(Fixed, ConversionsClampWhatDoesNotFit) {
    EXPECT_EQ(depth_from_ndc(-0.5f), 0);
    EXPECT_EQ(depth_from_ndc(infinity), depth_far);
    EXPECT_EQ(depth_from_ndc(nan), 0);
    EXPECT_EQ(attribute_from_float(infinity), attribute_from_float(attribute_limit));
    EXPECT_EQ(attribute_from_float(-1e30f), attribute_from_float(-attribute_limit));
    EXPECT_GT(attribute_from_float(infinity), attribute_from_float(3.9999f));
    EXPECT_LT(attribute_from_float(-infinity), attribute_from_float(-3.9999f));
    EXPECT_EQ(attribute_from_float(nan), attribute_from_float(-infinity));
}

TEST(Fixed, DepthEndsAtThePlanesAndBeforeTheClearValue) {
    EXPECT_EQ(depth_from_ndc(0.0f), 0);
    EXPECT_EQ(depth_from_ndc(1.0f), depth_far);
    EXPECT_LT(depth_far, depth_clear);
    EXPECT_EQ(ndc_from_depth(depth_far), 1.0f);
}

TEST(Fixed, DepthKeepsAll24BitsOfAFloatNearTheFarPlane) {
    float z = 1.0f;
    for (int i = 0; i < laws::million; ++i) {
        const float nearer = std::nextafter(z, 0.0f);
        ASSERT_LT(depth_from_ndc(nearer), depth_from_ndc(z)) << nearer;
        z = nearer;
    }
}

TEST(Fixed, DepthNeverFallsWhenZGrows) {
    laws::Random random(1);
    for (int i = 0; i < laws::million; ++i) {
        const float a = random.real(0.0f, 1.0f);
        const float b = random.real(0.0f, random.one_in(2) ? 1.0f : 1e-6f);
        ASSERT_LE(depth_from_ndc(std::min(a, b)), depth_from_ndc(std::max(a, b)));
    }
}

TEST(Fixed, AttributesComeBackWithinHalfAUnit) {
    laws::Random random(2);
    for (int i = 0; i < laws::million; ++i) {
        const float value = random.real(-3.99f, 3.99f);
        const double unit = 1.0 / attribute_one;
        ASSERT_NEAR(attribute_from_float(value) * unit, value, 0.5 * unit);
        ASSERT_NEAR(float_from_attribute(attribute_from_float(value)), value, 3e-7);
    }
}

}  // namespace
}  // namespace scanlight::raster
