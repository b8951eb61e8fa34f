#include "shading/fresnel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shading/metals.h"
#include "shading/refraction.h"
#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int trials = 10000;

/// The chapter's amplitudes: of the angle, not of g.
double by_amplitudes(double c_1, double n) {
    const auto c_2 = refracted_cosine(1.0, n, c_1);
    if (!c_2) return 1;
    const double across = (c_1 - n * *c_2) / (c_1 + n * *c_2);
    const double along = (n * c_1 - *c_2) / (n * c_1 + *c_2);
    return (across * across + along * along) / 2;
}

TEST(Fresnel, IsThatOfTheAmplitudes) {
    Random random(1);
    int total = 0;
    for (int i = 0; i < trials; ++i) {
        const double n = std::exp2(random.between(-1.5, 1.5));
        const double c = random.between(0.001, 1);
        const double expected = by_amplitudes(c, n);
        ASSERT_NEAR(fresnel(c, n), expected, 1e-9) << c << ' ' << n;
        total += expected == 1 ? 1 : 0;
    }
    EXPECT_GT(total, trials / 20);
}

/// What is mirrored on the way in is mirrored on the way out (Stokes 1849).
TEST(Fresnel, IsTheSameFromBothSides) {
    Random random(2);
    for (int i = 0; i < trials; ++i) {
        const double n = random.between(1, 3);
        const double c = random.between(0.01, 1);
        const double c_within = refracted_cosine(1.0, n, c).value();
        ASSERT_NEAR(fresnel(c_within, 1 / n), fresnel(c, n), 1e-9);
    }
}

TEST(Fresnel, GrowsTowardsGrazingFromBrewstersAngleOn) {
    double before = 0;
    for (double c = 1 / std::sqrt(1 + 1.5 * 1.5); c > 0; c -= 0.001) {
        ASSERT_GT(fresnel(c, 1.5), before);
        before = fresnel(c, 1.5);
    }
    EXPECT_EQ(fresnel(0.0, 1.5), 1);
}

/// Cosines and indices at which something may divide by 0.
template <class Real>
constexpr std::array edge_cosines{Real(0),   Real(1e-15), Real(1e-6),
                                  Real(0.5), Real(1),     Real(1.0000002)};
template <class Real>
constexpr std::array edge_indices{Real(0.1), Real(0.99999994), Real(1),   Real(1.0000001),
                                  Real(1.5), Real(78),         Real(4000)};

TEST(Fresnel, OfEqualMediaIsExactlyNothing) {
    in_both_precisions([]<class Real>() {
        for (const Real c : edge_cosines<Real>)
            EXPECT_EQ(fresnel(c, Real(1)), Real(0)) << c;
    });
}

/// With the same index in all channels.
template <class Real>
Real grey_metal(Real c, Real n, Real k) {
    return fresnel_metal(c, metal_indices(Rgb<Real>(n), Rgb<Real>(k))).x;
}

TEST(Fresnel, LiesWithinZeroAndOneWhereverItIsAsked) {
    in_both_precisions([]<class Real>() {
        const double one = 1 + tolerance<Real>;
        for (const Real c : edge_cosines<Real>) {
            for (const Real n : edge_indices<Real>) {
                ASSERT_TRUE(fresnel(c, n) >= 0 && fresnel(c, n) <= one) << c << ' ' << n;
                for (const Real k : {Real(0), Real(0.001), Real(1), Real(8)}) {
                    const Real rho = grey_metal(c, n, k);
                    ASSERT_TRUE(rho >= 0 && rho <= one) << c << ' ' << n << ' ' << k;
                }
            }
        }
    });
}

TEST(FresnelMetal, WithoutAbsorptionIsTheDielectrics) {
    Random random(3);
    for (int i = 0; i < trials; ++i) {
        const double n = std::exp2(random.between(-1.5, 2));
        const double c = random.between(0, 1);
        ASSERT_NEAR(grey_metal(c, n, 0.0), fresnel(c, n), 1e-7) << c << ' ' << n;
    }
}

TEST(FresnelMetal, StraightBackIsThatOfTheComplexIndex) {
    Random random(4);
    for (int i = 0; i < trials; ++i) {
        const double n = random.between(0.05, 4);
        const double k = random.between(0, 8);
        const double expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
        ASSERT_NEAR(grey_metal(1.0, n, k), expected, 1e-12);
    }
}

TEST(FresnelMetal, AtGrazingIsTheLights) {
    for (const Metal& m : metals()) {
        const Reflectance material = metal(m.n, m.k);
        expect_value(reflectance_at(0.0, material), {1, 1, 1});
        EXPECT_EQ(reflectance_at(1.0, material), material.C_0) << m.name;
    }
}

TEST(FresnelMetal, IsInEachChannelWhatItWouldBeAlone) {
    Random random(5);
    for (int i = 0; i < trials; ++i) {
        const auto index = [&] { return random.between(0.05, 8); };
        const double c = random.between(1e-6, 1);
        const Rgb<double> n(index(), index(), index());
        const Rgb<double> k(index(), index(), index());
        const Rgb<double> all = fresnel_metal(c, metal_indices(n, k));
        for (int j = 0; j < 3; ++j) {
            const auto [mirrored, of] = metal_share(c, metal_index(n[j], k[j]));
            ASSERT_NEAR(all[j], mirrored / of, 1e-14) << c;
        }
    }
}

TEST(FresnelMetal, OfAnyIndexIsANumber) {
    for (const double n : {0.0, 1e-30, 1e6, 1e300}) {
        const Reflectance material = metal(Rgb<double>(n), Rgb<double>(n));
        for (const float c : {0.0f, 1e-30f, 1e-4f, 1.0f}) {
            const float rho = reflectance_at(c, material).x;
            EXPECT_TRUE(rho >= 0 && rho <= 1) << n << ' ' << c;
        }
    }
}

TEST(IndexFromReflectance, GivesTheReflectanceBack) {
    for (const double rho_0 : {0.0, 0.04, 0.35, 0.64, 0.95, 0.999})
        EXPECT_NEAR(fresnel(1.0, index_from_reflectance(rho_0)), rho_0, 1e-12);
}

TEST(FresnelColor, GoesFromTheMaterialsColorToTheLights) {
    const Reflectance fast = shifted(metal_of_color({0.95, 0.64, 0.35}));
    expect_value(reflectance_at(1.0, fast), {0.95, 0.64, 0.35});
    expect_value(reflectance_at(0.0, fast), {1, 1, 1});
    Rgb<double> before = fast.C_0;
    for (double c = 1; c > 0; c -= 0.001) {
        const Rgb<double> color = reflectance_at(c, fast);
        for (int k = 0; k < 3; ++k)
            ASSERT_GE(color[k], before[k]) << c;
        before = color;
    }
}

/// The fast form is for metals; how far it is off, at worst, which is near grazing.
TEST(FresnelColor, IsNearTheExactOneOfEachMetal) {
    for (const Metal& m : metals()) {
        const Reflectance exact = metal(m.n, m.k);
        const Reflectance fast = shifted(exact);
        for (double c = 0; c <= 1; c += 0.01) {
            const Rgb<double> off = reflectance_at(c, fast) - reflectance_at(c, exact);
            for (int k = 0; k < 3; ++k)
                ASSERT_LT(std::abs(off[k]), 0.5) << m.name << ' ' << c;
        }
    }
}

TEST(FresnelColor, OfACarelessColorIsANumber) {
    for (const double rho_0 : {-1.0, 0.0, 1.0, 7.0, std::nan("")}) {
        const Reflectance material = shifted(metal_of_color(Rgb<double>(rho_0)));
        const double rho = reflectance_at(0.3, material).x;
        EXPECT_TRUE(rho >= 0 && rho <= 1) << rho_0;
    }
}

TEST(Metals, MirrorTheColorsTheyAreKnownBy) {
    const auto color = [](std::string_view name) {
        for (const Metal& m : metals()) {
            if (m.name == name) return metal(m.n, m.k).C_0;
        }
        return Rgb<double>(0);
    };
    expect_value(color("gold"), {0.930978291, 0.643419999, 0.408220334});
    for (const char* red : {"gold", "copper"}) {
        EXPECT_GT(color(red).x, 0.85);
        EXPECT_GT(color(red).x, 1.3 * color(red).y);
        EXPECT_GT(color(red).y, color(red).z);
    }
    for (const char* white : {"silver", "aluminium"}) {
        EXPECT_GT(color(white).x, 0.88);
        EXPECT_NEAR(color(white).x, color(white).z, 0.05);
    }
    for (const char* gray : {"iron", "titanium", "chromium"}) {
        EXPECT_NEAR(color(gray).x, 0.57, 0.05);
        EXPECT_NEAR(color(gray).x, color(gray).z, 0.07);
    }
}

}  // namespace
}  // namespace scanlight::shading
