#include "shading/cook_torrance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "shading/illumination.h"
#include "shading/metals.h"
#include "tests/shading/hemisphere.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int trials = 3000;
constexpr FacetDistribution every_distribution[] = {
    FacetDistribution::beckmann, FacetDistribution::gauss, FacetDistribution::cosine};

const Vec3<double> z_axis{0, 0, 1};

Reflectance random_reflectance(Random& random) {
    const double kind = random.between(0, 3);
    if (kind < 1) return dielectric(random.between(1, 2.5));
    const auto& m = metals()[static_cast<std::size_t>(random.between(0, 6.99))];
    return kind < 2 ? metal(m.n, m.k) : shifted(metal(m.n, m.k));
}

FacetSlopes random_slopes(Random& random) {
    const auto distribution = every_distribution[static_cast<int>(random.between(0, 2.99))];
    return {distribution, random.between(0.05, 0.7)};
}

/// R_s is the same with light and eye in each other's place; the (N.L) that is here times it is
/// not.
TEST(CookTorrance, IsReciprocal) {
    Random random(1);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.above(N, 0.01);
        const Vec3<double> V = random.above(N, 0.01);
        const FacetSlopes slopes = random_slopes(random);
        const Reflectance material = random_reflectance(random);
        const Rgb<double> there = cook_torrance(N, L, V, slopes, material) / dot(N, L);
        const Rgb<double> back = cook_torrance(N, V, L, slopes, material) / dot(N, V);
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(there[k], back[k], 1e-9 * (1 + there[k]));
    }
}

TEST(CookTorrance, IsTheSameOnBothSidesOfThePlaneOfIncidence) {
    Random random(2);
    const Reflectance glass = dielectric(1.5);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> V = polar<double>(random.between(0, 89), 0);
        const Vec3<double> L = random.above(z_axis);
        const FacetSlopes slopes = random_slopes(random);
        const Rgb<double> left = cook_torrance(z_axis, L, V, slopes, glass);
        const Rgb<double> right = cook_torrance(z_axis, {L.x, -L.y, L.z}, V, slopes, glass);
        ASSERT_NEAR(left.x, right.x, 1e-12 * (1 + left.x));
    }
}

/// In a white furnace, where light comes from all sides alike, no surface is brighter than the
/// furnace.
TEST(CookTorrance, SendsBackNoMoreThanArrives) {
    for (const auto distribution : every_distribution) {
        for (const double m : {0.15, 0.3, 0.6}) {
            const FacetSlopes slopes(distribution, m);
            for (const double theta : {0.0, 30.0, 60.0, 75.0, 85.0})
                EXPECT_LE(albedo_of(slopes, polar<double>(theta, 0)), 1.003) << m << ' ' << theta;
        }
    }
}

/// As printed, Beckmann's and the paper's constant make light.
TEST(CookTorrance, WithTheTextbooksConstantMakesLight) {
    const FacetSlopes slopes(FacetDistribution::beckmann, 0.3, FacetConstant::textbook);
    EXPECT_GT(albedo_of(slopes, z_axis), 3.9);
}

/// The least of three fractions, nowhere divided by N.L.
TEST(CookTorrance, IsTheLeastOfThreeFractions) {
    Random random(3);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> L = random.above(z_axis);
        const Vec3<double> V = random.above(z_axis, 0.001);
        const Vec3<double> H = half_vector(L, V);
        const FacetSlopes slopes = random_slopes(random);
        const double VH = dot(V, H);
        const double least = std::min({1 / V.z, 2 * H.z / VH, 2 * H.z * L.z / (VH * V.z)});
        const double expected = facet_density(H.z, slopes) * fresnel(VH, 1.5) * least / 4;
        ASSERT_NEAR(cook_torrance(z_axis, L, V, slopes, dielectric(1.5)).x, expected,
                    1e-12 * (1 + expected));
    }
}

TEST(CookTorrance, OfLightOrEyeBehindTheSurfaceIsNothing) {
    const FacetSlopes slopes(FacetDistribution::beckmann, 0.3);
    const Vec3<double> above = polar<double>(40, 0);
    for (const double theta : {90.0 + 1e-9, 100.0, 180.0}) {
        const Vec3<double> behind = polar<double>(theta, 120);
        EXPECT_EQ(cook_torrance(z_axis, behind, above, slopes, dielectric(1.5)), Rgb<double>(0));
        EXPECT_EQ(cook_torrance(z_axis, above, behind, slopes, dielectric(1.5)), Rgb<double>(0));
    }
}

/// Directions along the axes, nearly level with the surface, and opposed to each other.
template <class Real>
std::vector<Vec3<Real>> edge_directions() {
    std::vector<Vec3<Real>> result;
    for (const double height : {-1.0, -1e-7, 0.0, 1e-30, 1e-7, 1e-4, 0.5, 1.0}) {
        for (const double across : {-1.0, 0.0, 1.0})
            result.push_back(
                unit_or(Vec3<Real>(Vec3<double>(across, 0, height)), Vec3<Real>(Real(0))));
    }
    return result;
}

TEST(CookTorrance, IsANumberForAnyDirections) {
    in_both_precisions([]<class Real>() {
        Random random(4);
        const Vec3<Real> N(Real(0), Real(0), Real(1));
        for (const Vec3<Real>& L : edge_directions<Real>()) {
            for (const Vec3<Real>& V : edge_directions<Real>()) {
                for (int i = 0; i < 20; ++i) {
                    const FacetSlopes slopes = random_slopes(random);
                    const Rgb<Real> light =
                        cook_torrance(N, L, V, slopes, random_reflectance(random));
                    for (int k = 0; k < 3; ++k)
                        ASSERT_TRUE(light[k] >= 0 && std::isfinite(light[k]));
                }
            }
        }
    });
}

Material<double> material_of(const Reflectance& reflectance, double share) {
    return {.diffuse = Rgb<double>(0.5),
            .facets = {{FacetDistribution::beckmann, 0.25}, reflectance, share}};
}

Rgb<double> lit_from(const Material<double>& material, double light_deg, double eye_deg) {
    const Surface<double> surface{Vec3<double>(0), z_axis, polar<double>(eye_deg, 180)};
    const auto light = directional_light(polar<double>(light_deg, 0), Rgb<double>(1));
    return illuminate<CookTorrance>(surface, material, {Rgb<double>(0), {light}});
}

/// The diffuse halves of both models agree.
TEST(CookTorrance, WithoutFacetsIsLamberts) {
    const Rgb<double> light = lit_from(material_of(dielectric(1.5), 0), 40, 10);
    expect_value(light, Rgb<double>(0.5 * cos_deg<double>(40)));
}

TEST(CookTorrance, OfPlasticHasAHighlightOfTheLightsColor) {
    const Rgb<double> highlight = lit_from(material_of(dielectric(1.5), 1), 30, 30);
    EXPECT_GT(highlight.x, 0.1);
    EXPECT_EQ(highlight.x, highlight.y);
    EXPECT_EQ(highlight.x, highlight.z);
}

TEST(CookTorrance, OfCopperTurnsToTheLightsColorTowardsGrazing) {
    const auto copper = std::ranges::find(metals(), "copper", &Metal::name);
    const auto redness = [&](double degrees) {
        const Rgb<double> c =
            lit_from(material_of(metal(copper->n, copper->k), 1), degrees, degrees);
        return c.x / c.z;
    };
    EXPECT_GT(redness(10), 1.6);
    EXPECT_LT(redness(88), 1.2);
}

/// Where Phong's highlight stays as it is.
TEST(CookTorrance, HighlightGrowsTowardsGrazing) {
    double before = 0;
    for (const double degrees : {0.0, 30.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
        const double highlight = lit_from(material_of(dielectric(1.5), 1), degrees, degrees).x;
        EXPECT_GT(highlight, before) << degrees;
        before = highlight;
    }
}

/// The peak lies beyond the mirror direction: off-specular reflection, Torrance and Sparrow's find.
TEST(CookTorrance, PeaksBeyondTheMirrorDirectionAtGrazingLight) {
    const Material<double> material = material_of(dielectric(1.5), 1);
    double best = 0, peak = 0;
    for (double eye = 40; eye < 90; eye += 0.25) {
        const double light = lit_from(material, 65, eye).x;
        if (light > best) std::tie(best, peak) = std::pair(light, eye);
    }
    EXPECT_GT(peak, 70);
}

}  // namespace
}  // namespace scanlight::shading
