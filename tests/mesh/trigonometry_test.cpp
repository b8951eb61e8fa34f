#include "mesh/trigonometry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/mesh/soups.h"

namespace scanlight::mesh {
namespace {

template <class Check>
void for_many_angles(Check&& check) {
    Dice dice(9);
    for (int i = 0; i < 200000; ++i) {
        check(dice.between(-10, 10));
        check(dice.between(-1e6, 1e6));
    }
    for (int quarter = -1000; quarter <= 1000; ++quarter) {
        check(quarter * (pi / 4));
        check(std::nextafter(quarter * (pi / 4), 1e9));
    }
    for (const double x : {0.0, 1e-300, 1e-9, 1e6, -1e6, 636619.0 * (pi / 2)}) {
        check(x);
    }
}

TEST(Trigonometry, SineAndCosineAreWithin1eMinus15) {
    for_many_angles([](double x) {
        const long double exact = x;
        ASSERT_NEAR(sine(x), static_cast<double>(std::sin(exact)), 1e-15) << x;
        ASSERT_NEAR(cosine(x), static_cast<double>(std::cos(exact)), 1e-15) << x;
    });
}

TEST(Trigonometry, TangentIsWithin1eMinus15AwayFromItsPoles) {
    for_many_angles([](double x) {
        const auto exact = static_cast<double>(std::tan(static_cast<long double>(x)));
        if (std::abs(exact) > 4.0) return;
        ASSERT_NEAR(tangent(x), exact, 1e-15 * (1.0 + exact * exact)) << x;
    });
}

TEST(Trigonometry, SineIsOddAndCosineEven) {
    for_many_angles([](double x) {
        ASSERT_EQ(sine(-x), -sine(x));
        ASSERT_EQ(cosine(-x), cosine(x));
    });
}

TEST(Trigonometry, AngleOfAgreesWithSineAndCosine) {
    Dice dice(10);
    for (int i = 0; i < 200000; ++i) {
        const double x = dice.between(-1, 1);
        const double y = dice.between(-1, 1) * std::pow(10.0, dice.between(-20, 3));
        long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        if (exact < 0) exact += 2 * 3.14159265358979323846264338328L;
        ASSERT_NEAR(angle_of(y, x), static_cast<double>(exact), 2e-15) << y << " " << x;
    }
}

TEST(Trigonometry, AngleOfTheAxesIsExact) {
    EXPECT_EQ(angle_of(0, 1), 0.0);
    EXPECT_EQ(angle_of(1, 0), pi / 2);
    EXPECT_EQ(angle_of(0, -1), pi);
    EXPECT_EQ(angle_of(-1, 0), 3 * pi / 2);
    EXPECT_EQ(angle_of(0, 0), 0.0);
}

}  // namespace
}  // namespace scanlight::mesh
