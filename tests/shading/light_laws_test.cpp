// Laws of reflection, refraction, energy and solid angle, on seeded random input.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "shading/radiometry.h"
#include "shading/reflection.h"
#include "shading/refraction.h"
#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int trials = 10000;

TEST(Reflection, KeepsTheAngleThePlaneAndTheLength) {
    Random random(1);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.unit_vector();
        const Vec3<double> R = reflected(L, N);
        ASSERT_NEAR(dot(N, R), dot(N, L), 1e-14);
        ASSERT_NEAR(dot(glm::cross(N, L), R), 0, 1e-14);
        ASSERT_NEAR(dot(R, R), 1, 1e-14);
    }
}

TEST(Reflection, TurnsTheTangentialPartRound) {
    Random random(2);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.unit_vector();
        const Vec3<double> sum = L + reflected(L, N);
        ASSERT_NEAR(glm::length(sum - N * (2 * dot(N, L))), 0, 1e-14);
    }
}

TEST(Reflection, TwiceIsTheIdentity) {
    Random random(3);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.unit_vector();
        ASSERT_NEAR(glm::length(reflected(reflected(L, N), N) - L), 0, 1e-14);
    }
}

double sine_of(double cosine) {
    return std::sqrt(1 - cosine * cosine);
}

TEST(Refraction, KeepsIndexTimesSineOrReflectsTotally) {
    Random random(4);
    int total_reflections = 0;
    for (int i = 0; i < trials; ++i) {
        const double eta_1 = random.between(1, 2.5);
        const double eta_2 = random.between(1, 2.5);
        const double cos_theta = random.between(0, 1);
        const double conserved = eta_1 * sine_of(cos_theta);
        if (std::abs(conserved - eta_2) < 1e-6) continue;  // the critical angle itself
        const auto cos_phi = refracted_cosine(eta_1, eta_2, cos_theta);
        ASSERT_EQ(cos_phi.has_value(), conserved < eta_2);
        if (cos_phi)
            ASSERT_NEAR(eta_2 * sine_of(*cos_phi), conserved, 1e-8);
        else
            ++total_reflections;
    }
    EXPECT_GT(total_reflections, trials / 20);
}

TEST(Refraction, IsReversible) {
    Random random(5);
    for (int i = 0; i < trials; ++i) {
        const double eta = random.between(1, 2.5);
        const double cos_theta = random.between(0.01, 1);
        const auto there = refracted_cosine(1.0, eta, cos_theta);
        const auto back = refracted_cosine(eta, 1.0, there.value());
        ASSERT_NEAR(back.value(), cos_theta, 1e-10);
    }
}

TEST(Refraction, GoesStraightOnAlongTheNormalAndBetweenEqualMedia) {
    EXPECT_EQ(refracted_cosine(1.0, 1.5, 1.0), 1.0);
    EXPECT_EQ(refracted_cosine(1.5, 1.0, 1.0), 1.0);
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const double cos_theta = random.between(0, 1);
        ASSERT_NEAR(refracted_cosine(1.3, 1.3, cos_theta).value(), cos_theta, 1e-12);
    }
}

TEST(Refraction, GrazingLightBetweenEqualMediaIsNotTotallyReflected) {
    EXPECT_EQ(refracted_cosine(1.5f, 1.5f, 0.0f), 0.0f);
}

/// The angle of T to the other side, by its tangent: with no index in it.
double sine_beyond(const Vec3<double>& T, const Vec3<double>& N) {
    return glm::length(glm::cross(T, N)) / glm::length(T);
}

TEST(RefractedDirection, KeepsSnellsLawAndThePlane) {
    Random random(8);
    int total_reflections = 0;
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N);
        const double eta = std::exp2(random.between(-1.2, 1.2));
        const double sine = glm::length(glm::cross(V, N));
        const Vec3<double> T = refracted(V, N, eta);
        if (sine > eta) {
            ++total_reflections;
            ASSERT_EQ(T, Vec3<double>(0));
            continue;
        }
        ASSERT_NEAR(glm::length(T), 1, 1e-12);
        ASSERT_LE(dot(T, N), 0);
        ASSERT_NEAR(eta * sine_beyond(T, N), sine, 1e-12);
        ASSERT_NEAR(dot(glm::cross(N, V), T), 0, 1e-12);
        ASSERT_LE(dot(T - N * dot(T, N), V - N * dot(V, N)), 0);  // on the other side of N
    }
    EXPECT_GT(total_reflections, trials / 20);
}

TEST(RefractedDirection, OfWhittedMadeUnitIsHeckberts) {
    Random random(9);
    int total_reflections = 0;
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N, 0.01);
        const double eta = std::exp2(random.between(-1.2, 1.2));
        const Vec3<double> heckbert = refracted(V, N, eta);
        if (std::abs(dot(heckbert, N)) < 1e-4 && heckbert != Vec3<double>(0)) continue;
        const Vec3<double> whitted = whitted_refracted(V, N, eta);
        if (heckbert == Vec3<double>(0)) {
            ++total_reflections;
            ASSERT_EQ(whitted, heckbert);
        } else {
            ASSERT_NEAR(dot(whitted, N), -1, 1e-9);
            ASSERT_NEAR(glm::length(unit(whitted) - heckbert), 0, 1e-9);
        }
    }
    EXPECT_GT(total_reflections, trials / 20);
}

TEST(RefractedDirection, IsReversible) {
    Random random(10);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N, 0.01);
        const double eta = random.between(1, 2.5);
        const Vec3<double> T = refracted(V, N, eta);
        ASSERT_NEAR(glm::length(refracted(T, -N, 1 / eta) - V), 0, 1e-10);
    }
}

TEST(RefractedDirection, GoesStraightOnBetweenEqualMediaAndAlongTheNormal) {
    Random random(11);
    for (int i = 0; i < 100; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> V = random.above(N, 0.01);
        ASSERT_NEAR(glm::length(refracted(V, N, 1.0) + V), 0, 1e-12);
        ASSERT_NEAR(glm::length(refracted(N, N, 1.5) + N), 0, 1e-12);
    }
}

TEST(Energy, ShareLeftIsTakenChannelByChannel) {
    using Color = Rgb<double>;
    const Color left = energy_left(Color(1), Color(0.5, 0.2, 0), Color(0.3, 0.2, 0), Color(0.1));
    expect_value(left, {0.1, 0.5, 0.9});
}

TEST(Energy, MaterialThatMakesLightInOneChannelIsRejected) {
    using Color = Rgb<float>;
    const Color diffuse(0.5f);
    const Color specular(0.3f);
    EXPECT_TRUE(conserves_energy(diffuse, specular, Color(0.2f)));  // exactly 1, up to rounding
    EXPECT_FALSE(conserves_energy(diffuse, specular, Color(0.20001f, 0.2f, 0.2f)));
    EXPECT_FALSE(conserves_energy(diffuse, specular, Color(0.2f, 0.20001f, 0.2f)));
    EXPECT_FALSE(conserves_energy(diffuse, specular, Color(0.2f, 0.2f, 0.20001f)));
}

/// Sums `element(area, cos_theta, r)` over the six faces of a cube around a point off its middle.
template <class Element>
double sum_over_cube(const Vec3<double>& center, Element element) {
    constexpr int cells = 200;
    constexpr double step = 2.0 / cells;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i < cells * cells; ++i) {
                Vec3<double> p;
                p[axis] = side;
                p[(axis + 1) % 3] = (i % cells + 0.5) * step - 1;
                p[(axis + 2) % 3] = (i / cells + 0.5) * step - 1;
                const double r = glm::length(p - center);
                sum += element(step * step, side * (p - center)[axis] / r, r);
            }
        }
    }
    return sum;
}

const Vec3<double> off_center{0.3, -0.2, 0.4};

TEST(SolidAngle, OfAllDirectionsIsFourPi) {
    EXPECT_NEAR(sum_over_cube(off_center, solid_angle<double>), 4 * pi, 1e-3);
}

TEST(Flux, ThroughAnyClosedSurfaceIsFourPiTimesTheIntensity) {
    const double intensity = 7;
    const double through = sum_over_cube(off_center, [&](double area, double cosine, double r) {
        return irradiance(intensity, cosine, r) * area;
    });
    EXPECT_NEAR(through, isotropic_flux(intensity), 1e-2);
}

TEST(Flux, OfAnIntensityGivesTheIntensityBack) {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const double intensity = random.between(0.1, 100);
        const double r = random.between(0.1, 10);
        const double area = random.between(0.001, 0.1);
        const double flux = irradiance(intensity, 1.0, r) * area;
        ASSERT_NEAR(intensity_of(flux, area, r), intensity, 1e-12 * intensity);
    }
}

TEST(SolidAngle, OfAConeGrowsFromNothingToEverything) {
    EXPECT_EQ(cone_solid_angle(1.0), 0.0);
    EXPECT_NEAR(cone_solid_angle(0.0), 2 * pi, 1e-15);
    EXPECT_NEAR(cone_solid_angle(-1.0), 4 * pi, 1e-15);
}

}  // namespace
}  // namespace scanlight::shading
