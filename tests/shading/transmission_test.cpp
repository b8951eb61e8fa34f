#include "shading/transmission.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "shading/illumination.h"
#include "shading/refraction.h"
#include "shading/whitted.h"
#include "tests/shading/hemisphere.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int trials = 10000;

/// eta_2/eta_1, either side being the denser; never about 1.
double random_eta(Random& random) {
    const double denser = random.between(1.1, 2.5);
    return random.between(0, 1) < 0.5 ? denser : 1 / denser;
}

TEST(TransmittingNormal, IsTheNormalThatRefractsTheLightIntoTheView) {
    Random random(1);
    int refracted_lights = 0;
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N, 0.02);
        const double eta = random_eta(random);
        const Vec3<double> L = refracted(V, N, eta);
        if (L == Vec3<double>(0)) continue;  // total reflection
        const double grazing = dot(V, L) + std::min(eta, 1 / eta);
        if (grazing > -1e-6) continue;  // the edge of what is refracted at all
        ASSERT_NEAR(glm::length(transmitting_normal(L, V, eta) - N), 0, 1e-6);
        ASSERT_NEAR(transmitted_highlight(N, L, V, eta, 50), 1, 1e-9);
        ++refracted_lights;
    }
    EXPECT_GT(refracted_lights, trials / 2);
}

/// The way of light can be reversed.
TEST(TransmittingNormal, IsTurnedRoundWithLightAndEye) {
    Random random(2);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> V = random.unit_vector();
        const Vec3<double> L = random.unit_vector();
        const double eta = random_eta(random);
        const Vec3<double> there = transmitting_normal(L, V, eta);
        const Vec3<double> back = transmitting_normal(V, L, 1 / eta);
        ASSERT_NEAR(glm::length(there + back), 0, 1e-12);
    }
}

TEST(TransmittingNormal, DoesNotExistBeyondTheCriticalAngle) {
    const Vec3<double> V(0, 0, 1);
    const double limit = std::acos(1 / 1.5) * 180 / pi;
    const auto normal = [&](double degrees) {
        return transmitting_normal(-polar<double>(degrees, 0), V, 1.5);
    };
    EXPECT_NE(normal(limit - 0.001), Vec3<double>(0));
    EXPECT_EQ(normal(limit + 0.001), Vec3<double>(0));
    EXPECT_EQ(normal(120), Vec3<double>(0));
}

TEST(TransmittedHighlight, BetweenEqualMediaPeaksStraightBehind) {
    const Vec3<double> N(0, 0, 1);
    for (const double degrees : {0.0, 20.0, 70.0}) {
        const Vec3<double> V = polar<double>(degrees, 0);
        EXPECT_NEAR(transmitted_highlight(N, -V, V, 1.0, 100), 1, 1e-12);
        const Vec3<double> aside = -polar<double>(degrees + 10, 0);
        EXPECT_NEAR(transmitted_highlight(N, aside, V, 1.0, 100),
                    std::pow(cos_deg<double>(10), 100), 1e-9);
    }
}

TEST(Transmission, IsOfLightsBehindOnly) {
    Random random(3);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N);
        const Vec3<double> L = random.above(N);
        ASSERT_EQ(transmitted_diffuse(N, L), 0);
        ASSERT_EQ(transmitted_highlight(N, L, V, random_eta(random), 3), 0);
        ASSERT_EQ(transmitted_highlight(N, L, V, 1.0, 3), 0);
    }
}

Material<double> frosted_glass(Random& random) {
    return {.diffuse = random.color(),
            .specular = random.color(),
            .exponent = 20,
            .transmission = {random.color(), random.color(), 30, random_eta(random)}};
}

TEST(Hall, OfAnOpaqueBodyIsBlinns) {
    Random random(4);
    for (int i = 0; i < trials; ++i) {
        Material<double> material = frosted_glass(random);
        material.transmission = {};
        const Surface<double> surface{random.in_cube(2), random.unit_vector(),
                                      random.unit_vector()};
        const Vec3<double> towards = random.unit_vector();
        const auto light = directional_light(towards, random.color());
        const Lighting<double> lighting{Rgb<double>(0.1), {light}};
        ASSERT_EQ(illuminate<Hall>(surface, material, lighting),
                  illuminate<Blinn>(surface, material, lighting));
    }
}

TEST(Hall, LightBehindComesThroughAndLightBeforeDoesNot) {
    Random random(5);
    for (int i = 0; i < trials; ++i) {
        const Material<double> material = frosted_glass(random);
        const Vec3<double> N = random.unit_vector();
        const Surface<double> surface{Vec3<double>(0), N, random.above(N)};
        const Vec3<double> L = random.above(N, 0.01);
        const auto lit_from = [&]<class Model>(const Vec3<double>& towards) {
            const auto light = directional_light(towards, Rgb<double>(1));
            return illuminate<Model>(surface, material, {Rgb<double>(0), {light}});
        };
        ASSERT_EQ(lit_from.operator()<Hall>(L), lit_from.operator()<Blinn>(L));
        ASSERT_EQ(lit_from.operator()<Blinn>(-L), Rgb<double>(0));
        ASSERT_GT(lit_from.operator()<Hall>(-L).x,
                  0.99 * material.transmission.diffuse.x * dot(N, L));
    }
}

TEST(Hall, IsANumberForAnyDirections) {
    Random random(6);
    for (int i = 0; i < trials; ++i) {
        const Vec3<float> N(random.unit_vector());
        const Vec3<float> L(random.unit_vector());
        const Vec3<float> V(random.unit_vector());
        for (const float eta : {0.5f, 0.9999999f, 1.0f, 1.0000001f, 1.5f, 2.5f}) {
            for (const Vec3<float>& light : {L, -V, V, -N, N}) {
                const float highlight = transmitted_highlight(N, light, V, eta, 10);
                ASSERT_TRUE(highlight >= 0 && highlight <= 1);
            }
        }
    }
}

TEST(Whitted, AtTotalReflectionLosesNothing) {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const Rgb<double> local = random.color();
        const Rgb<double> I = random.color();
        const Rgb<double> K_s = random.color();
        const Rgb<double> K_t = random.color();
        const Rgb<double> total = whitted_at_total_reflection(local, I, K_s, K_t);
        ASSERT_NEAR(glm::length(total - whitted(local, I, K_s, I, K_t)), 0, 1e-14);
    }
}

}  // namespace
}  // namespace scanlight::shading
