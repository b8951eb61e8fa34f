#include "shading/light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr Falloff every_falloff[] = {Falloff::constant, Falloff::inverse, Falloff::inverse_square,
                                     Falloff::inverse_plus_k};
const Rgb<float> white{1, 1, 1};

TEST(Falloff, NeverGrowsWithDistanceAndIsFiniteAtTheLamp) {
    for (const Falloff falloff : every_falloff) {
        const DistanceLaw<float> law{.falloff = falloff};
        float nearer = share_at(law, 0.0f);
        EXPECT_TRUE(std::isfinite(nearer));
        for (float r = 0x1p-12f; r < 1000; r *= 1.01f) {
            const float share = share_at(law, r);
            ASSERT_LE(share, nearer);
            ASSERT_GT(share, 0);
            nearer = share;
        }
    }
}

TEST(Falloff, IsClampedBelowTheLeastDistanceOnly) {
    const DistanceLaw<double> law{.falloff = Falloff::inverse_square, .r_min = 0.5};
    EXPECT_EQ(share_at(law, 0.0), 4.0);
    EXPECT_EQ(share_at(law, 0.5), 4.0);
    EXPECT_LT(share_at(law, 0.5001), 4.0);
}

TEST(Falloff, TakesItsOwnConstant) {
    const DistanceLaw<double> law{.falloff = Falloff::inverse_plus_k, .k = 3};
    EXPECT_EQ(share_at(law, 1.0), 0.25);
    const DistanceLaw<double> without{.falloff = Falloff::inverse_plus_k, .k = 0, .r_min = 0.5};
    EXPECT_EQ(share_at(without, 0.0), 2);
}

TEST(DirectionalLight, IsTheSameEverywhereWhateverItsDistanceLaw) {
    Light<float> light = directional_light(Vec3<float>(0, 3, 4), white);
    light.law.falloff = Falloff::inverse_square;
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const auto [direction, intensity, distance] =
            incident_at(light, Vec3<float>(random.in_cube(100)));
        ASSERT_EQ(direction, Vec3<float>(0, 0.6f, 0.8f));
        ASSERT_EQ(intensity, white);
        ASSERT_TRUE(std::isinf(distance));
    }
}

TEST(DirectionalLight, WithoutADirectionComesFromNowhere) {
    const Light<float> light = directional_light(Vec3<float>(0), white);
    EXPECT_EQ(incident_at(light, Vec3<float>(1, 2, 3)).direction, Vec3<float>(0));
}

TEST(PointLight, ShinesFromItsPositionByItsLaw) {
    const DistanceLaw<double> law{.falloff = Falloff::inverse_square};
    const Light<double> light = point_light(Vec3<double>(1, 2, 10), Rgb<double>(8, 4, 2), law);
    const Incident<double> incident = incident_at(light, Vec3<double>(1, 2, 8));
    EXPECT_EQ(incident.direction, Vec3<double>(0, 0, 1));
    EXPECT_EQ(incident.intensity, Rgb<double>(2, 1, 0.5));
    EXPECT_EQ(incident.distance, 2);
}

TEST(PointLight, KeepsItsIntensityUnlessALawSaysOtherwise) {
    const Light<float> light = point_light(Vec3<float>(0, 0, 100), white);
    EXPECT_EQ(incident_at(light, Vec3<float>(0)).intensity, white);
}

TEST(PointLight, IsFiniteAtItsOwnPosition) {
    for (const Falloff falloff : every_falloff) {
        const Vec3<float> position(1, 2, 3);
        const Light<float> light = point_light(position, white, {.falloff = falloff});
        const Incident<float> incident = incident_at(light, position);
        EXPECT_EQ(incident.direction, Vec3<float>(0));
        EXPECT_TRUE(std::isfinite(incident.intensity.x));
        EXPECT_EQ(incident.distance, 0);
    }
}

TEST(PointLight, FarAwayLooksDirectional) {
    const Vec3<double> towards = along<double>(1, 2, 3);
    const Light<double> far_away = point_light(towards * 1e6, Rgb<double>(1));
    const Vec3<double> direction = incident_at(far_away, Vec3<double>(1, -1, 1)).direction;
    EXPECT_NEAR(dot(direction, towards), 1, 1e-11);
}

}  // namespace
}  // namespace scanlight::shading
