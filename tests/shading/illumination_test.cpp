#include "shading/illumination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/shading/precision.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int trials = 10000;
constexpr Illumination every_model[] = {Illumination::lambert, Illumination::gouraud71,
                                        Illumination::phong,   Illumination::blinn,
                                        Illumination::hall,    Illumination::cook_torrance};

Material<double> random_material(Random& random) {
    return {.ambient = random.color(),
            .diffuse = random.color(),
            .specular = random.color(),
            .exponent = std::exp2(random.between(0, 11)),
            .facets = {{FacetDistribution::beckmann, random.between(0.1, 0.6)},
                       dielectric(random.between(1, 2)),
                       random.between(0, 1)}};
}

Surface<double> random_surface(Random& random) {
    const Vec3<double> point = random.in_cube(2);
    const Vec3<double> normal = random.unit_vector();
    return {point, normal, random.above(normal)};
}

Light<double> random_directional_light(Random& random) {
    const Vec3<double> towards = random.unit_vector();
    return directional_light(towards, random.color());
}

Light<double> random_lamp(Random& random, const DistanceLaw<double>& law = {}) {
    const Vec3<double> position = random.in_cube(10);
    return point_light(position, random.color(), law);
}

Light<double> random_light(Random& random) {
    if (random.between(0, 1) < 0.5) return random_directional_light(random);
    return random_lamp(random, {.falloff = Falloff::inverse});
}

Rgb<double> illuminate_as(Illumination kind, const Surface<double>& surface,
                          const Material<double>& material, const Lighting<double>& lighting) {
    return with_illumination(
        kind, [&](auto model) { return illuminate(model, surface, material, lighting); });
}

TEST(Illumination, WithoutLightsIsTheAmbientTerm) {
    Random random(1);
    for (const Illumination kind : every_model) {
        const Lighting<double> lighting{random.color(), {}};
        const Material<double> material = random_material(random);
        EXPECT_EQ(illuminate_as(kind, random_surface(random), material, lighting),
                  lighting.ambient * material.ambient);
    }
}

TEST(Illumination, LightOfItsOwnIsAddedToAllOther) {
    Random random(11);
    for (int i = 0; i < trials; ++i) {
        const Illumination kind = every_model[i % 4];
        const Surface<double> surface = random_surface(random);
        const Lighting<double> lighting{random.color(), {random_light(random)}};
        Material<double> material = random_material(random);
        const Rgb<double> without = illuminate_as(kind, surface, material, lighting);
        material.emission = random.color();
        const Rgb<double> with = illuminate_as(kind, surface, material, lighting);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(with[c], without[c] + material.emission[c], 1e-12 * (1 + with[c]));
    }
}

TEST(Illumination, OfTwoLightsIsTheSumOfBothLessOneAmbientTerm) {
    Random random(2);
    for (int i = 0; i < trials; ++i) {
        const Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        const Rgb<double> I_a = random.color();
        const Light<double> a = random_light(random);
        const Light<double> b = random_light(random);
        for (const Illumination kind : every_model) {
            const auto lit_by = [&](const std::vector<Light<double>>& lights) {
                return illuminate_as(kind, surface, material, {I_a, lights});
            };
            const Rgb<double> difference =
                lit_by({a, b}) - (lit_by({a}) + lit_by({b}) - lit_by({}));
            ASSERT_NEAR(glm::length(difference), 0, 1e-14);
        }
    }
}

TEST(Illumination, ScalesWithTheLight) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        Light<double> light = random_light(random);
        for (const Illumination kind : every_model) {
            const Rgb<double> once =
                illuminate_as(kind, surface, material, {Rgb<double>(0), {light}});
            Light<double> doubled = light;
            doubled.intensity = doubled.intensity * 2.0;
            ASSERT_EQ(illuminate_as(kind, surface, material, {Rgb<double>(0), {doubled}}),
                      once * 2.0);
        }
    }
}

TEST(Illumination, OfDiffuseModelsDoesNotDependOnTheView) {
    Random random(4);
    for (int i = 0; i < trials; ++i) {
        Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        const Lighting<double> lighting{random.color(), {random_light(random)}};
        const Rgb<double> lambert = illuminate<Lambert>(surface, material, lighting);
        const Rgb<double> gouraud = illuminate<Gouraud1971>(surface, material, lighting);
        surface.view = random.unit_vector();
        ASSERT_EQ(illuminate<Lambert>(surface, material, lighting), lambert);
        ASSERT_EQ(illuminate<Gouraud1971>(surface, material, lighting), gouraud);
    }
}

TEST(Illumination, WithoutSpecularColorIsLamberts) {
    Random random(5);
    for (int i = 0; i < trials; ++i) {
        const Surface<double> surface = random_surface(random);
        Material<double> material = random_material(random);
        material.specular = Rgb<double>(0);
        const Lighting<double> lighting{random.color(), {random_light(random)}};
        const Rgb<double> lambert = illuminate<Lambert>(surface, material, lighting);
        ASSERT_EQ(illuminate<Phong>(surface, material, lighting), lambert);
        ASSERT_EQ(illuminate<Blinn>(surface, material, lighting), lambert);
    }
}

TEST(Illumination, OfASurfaceTurnedFromTheLightIsAmbientOnly) {
    Random random(6);
    for (int i = 0; i < trials; ++i) {
        const Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        const Vec3<double> behind = -random.above(surface.normal);
        const Lighting<double> lighting{random.color(),
                                        {directional_light(behind, random.color())}};
        for (const Illumination kind : every_model)
            ASSERT_EQ(illuminate_as(kind, surface, material, lighting),
                      lighting.ambient * material.ambient);
    }
}

TEST(Illumination, AtGrazingLightHasNoHighlight) {
    // L lies in the surface, and V along R: without the rule the highlight would be at its peak.
    const Vec3<double> N(0, 0, 1);
    const Vec3<double> L(1, 0, 0);
    const Vec3<double> V(-1, 0, 0);
    EXPECT_EQ(phong(N, L, V, 10), 0);
    EXPECT_EQ(blinn(N, L, N, 10), 0);
}

TEST(Illumination, IsNeverNegativeOrNanForAnyDirections) {
    const auto check = [](const Surface<float>& surface, const Vec3<float>& towards, double n) {
        const Material<float> material{.specular = Rgb<float>(1), .exponent = n};
        const Lighting<float> lighting{Rgb<float>(0.1f),
                                       {directional_light(towards, Rgb<float>(1))}};
        for (const Illumination kind : every_model) {
            const Rgb<float> intensity = with_illumination(
                kind, [&](auto model) { return illuminate(model, surface, material, lighting); });
            ASSERT_GE(intensity.x, 0.02f);  // false for NaN too
            ASSERT_LE(intensity.x, 0.02f + 1.801f);
        }
    };
    Random random(7);
    for (int i = 0; i < trials; ++i) {
        const Vec3<float> N(random.unit_vector());
        const Vec3<float> L(random.unit_vector());
        const Vec3<float> V(random.unit_vector());
        const double n = i % 3 == 0 ? 0 : std::exp2(random.between(0, 16));
        check({Vec3<float>(0), N, V}, L, n);
        check({Vec3<float>(0), N, V}, -V, n);  // H does not exist
        check({Vec3<float>(0), N, V}, V, n);
        check({Vec3<float>(0), N, -N}, N, n);
        check({Vec3<float>(0), N, N}, -N, n);
        check({Vec3<float>(0), N, N}, N, n);
    }
}

TEST(HalfVector, OfOpposedDirectionsLeavesNoHighlight) {
    const Vec3<double> L = along<double>(1, 2, 3);
    EXPECT_EQ(half_vector(L, -L), Vec3<double>(0));
    EXPECT_EQ(blinn(L, L, half_vector(L, -L), 10), 0);
}

TEST(HalfVector, MirrorsTheLightIntoTheView) {
    Random random(8);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> L = random.unit_vector();
        const Vec3<double> V = random.above(L, -0.9);
        ASSERT_NEAR(glm::length(reflected(L, half_vector(L, V)) - V), 0, 1e-13);
    }
}

TEST(Highlight, PeaksAtTheMirrorDirection) {
    Random random(9);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.above(N, 0.01);
        const Vec3<double> R = reflected(L, N);
        ASSERT_NEAR(phong(N, L, R, 50), 1, 1e-12);
        ASSERT_NEAR(blinn(N, L, half_vector(L, R), 50), 1, 1e-12);
    }
}

TEST(Highlight, NarrowsAsTheExponentGrows) {
    Random random(10);
    for (int i = 0; i < trials; ++i) {
        const Vec3<double> N = random.unit_vector();
        const Vec3<double> L = random.above(N, 0.7);
        const Vec3<double> V = random.above(reflected(L, N), 0.9);
        const Vec3<double> H = half_vector(L, V);
        double wider_phong = 1;
        double wider_blinn = 1;
        for (const double n : {1.0, 2.5, 10.0, 40.3, 100.0}) {
            ASSERT_LT(phong(N, L, V, n), wider_phong);
            ASSERT_LT(blinn(N, L, H, n), wider_blinn);
            wider_phong = phong(N, L, V, n);
            wider_blinn = blinn(N, L, H, n);
        }
    }
}

/// N, L and V in one plane: the light at `theta`, the eye `alpha` beyond its mirror image.
struct Coplanar {
    Vec3<double> N{0, 0, 1};
    Vec3<double> L;
    Vec3<double> V;
};

Coplanar coplanar(double theta, double alpha) {
    const double eye = theta + alpha;
    return {.L = {-std::sin(theta), 0, std::cos(theta)}, .V = {std::sin(eye), 0, std::cos(eye)}};
}

TEST(Highlight, OfBlinnWithFourTimesTheExponentIsPhongs) {
    Random random(11);
    for (int i = 0; i < trials; ++i) {
        const double theta = random.between(0, 1.2);
        const auto [N, L, V] = coplanar(theta, random.between(-0.3, 0.3));
        const double n = std::exp2(random.between(4, 10));
        const Vec3<double> H = half_vector(L, V);
        ASSERT_NEAR(std::acos(dot(N, H)), std::acos(dot(reflected(L, N), V)) / 2, 1e-7);
        ASSERT_NEAR(blinn(N, L, H, 4 * n), phong(N, L, V, n), 0.02);
    }
}

TEST(Highlight, OfBlinnIsWiderWithTheSameExponent) {
    const auto [N, L, V] = coplanar(0.5, 0.2);
    EXPECT_GT(blinn(N, L, half_vector(L, V), 50), 1.5 * phong(N, L, V, 50));
}

TEST(Gouraud1971, OfALightAtInfinityDividesByNothing) {
    Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        const Lighting<double> lighting{random.color(), {random_directional_light(random)}};
        ASSERT_EQ(illuminate<Gouraud1971>(surface, material, lighting),
                  illuminate<Lambert>(surface, material, lighting));
    }
}

TEST(Gouraud1971, IsLambertWithTheFalloffInversePlusK) {
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Surface<double> surface = random_surface(random);
        const Material<double> material = random_material(random);
        Light<double> lamp = random_lamp(random);
        const Rgb<double> gouraud =
            illuminate(Gouraud1971{.k = 2.5f}, surface, material, {Rgb<double>(0.1), {lamp}});
        lamp.law = {.falloff = Falloff::inverse_plus_k, .k = 2.5};
        const Rgb<double> lambert =
            illuminate<Lambert>(surface, material, Lighting<double>{Rgb<double>(0.1), {lamp}});
        ASSERT_NEAR(glm::length(gouraud - lambert), 0, 1e-15);
    }
}

TEST(WithIllumination, PicksTheNamedModel) {
    Random random(14);
    const Surface<double> surface{Vec3<double>(0), along<double>(0, 0, 1),
                                  along<double>(-1, -1, 4)};
    const Material<double> material = random_material(random);
    const Lighting<double> lighting{random.color(),
                                    {point_light(Vec3<double>(1, 2, 3), random.color())}};
    const auto as = [&](Illumination kind) {
        return illuminate_as(kind, surface, material, lighting);
    };
    EXPECT_EQ(as(Illumination::lambert), illuminate<Lambert>(surface, material, lighting));
    EXPECT_EQ(as(Illumination::gouraud71), illuminate<Gouraud1971>(surface, material, lighting));
    EXPECT_EQ(as(Illumination::phong), illuminate<Phong>(surface, material, lighting));
    EXPECT_EQ(as(Illumination::blinn), illuminate<Blinn>(surface, material, lighting));
    EXPECT_EQ(as(Illumination::hall), illuminate<Hall>(surface, material, lighting));
    EXPECT_EQ(as(Illumination::cook_torrance),
              illuminate<CookTorrance>(surface, material, lighting));
    EXPECT_NE(as(Illumination::phong), as(Illumination::blinn));
    EXPECT_NE(as(Illumination::lambert), as(Illumination::gouraud71));
}

TEST(FacingViewer, TurnsTheNormalToTheViewerAndOnlyIfNeeded) {
    Random random(15);
    for (int i = 0; i < 1000; ++i) {
        const Vec3<double> point = random.in_cube(5);
        const Vec3<double> normal = random.unit_vector();
        const Surface<double> surface{point, normal, random.unit_vector()};
        const Surface<double> facing = facing_viewer(surface);
        const bool seen_from_outside = dot(normal, surface.view) >= 0;
        ASSERT_EQ(facing.normal, seen_from_outside ? normal : -normal);
        ASSERT_EQ(facing.point, surface.point);
        ASSERT_EQ(facing.view, surface.view);
    }
}

TEST(FacingViewer, LightsTheBackOfASheet) {
    const Vec3<float> up(0, 0, 1);
    const Surface<float> back{Vec3<float>(0), -up, up};
    const Lighting<float> lighting{Rgb<float>(0), {directional_light(up, Rgb<float>(1))}};
    const Material<float> material{.diffuse = Rgb<float>(0.5f)};
    EXPECT_EQ(illuminate<Lambert>(back, material, lighting).x, 0.0f);
    EXPECT_EQ(illuminate<Lambert>(facing_viewer(back), material, lighting).x, 0.5f);
}

Reflectance some_reflectance(Random& random) {
    const Rgb<double> n(random.color());
    const Rgb<double> k(random.color() * 4.0);
    switch (static_cast<int>(random.between(0, 3))) {
        case 0:
            return metal(n, k);
        case 1:
            return shifted(metal(n, k));
        default:
            return dielectric(1.5);
    }
}

Material<float> some_material(Random& random) {
    Material<float> material;
    material.ambient = Rgb<float>(random.color());
    material.diffuse = Rgb<float>(random.color());
    material.specular = Rgb<float>(random.color());
    material.exponent = Exponent(std::floor(random.between(0, 40)));
    material.facets = {{static_cast<FacetDistribution>(random.between(0, 3)), 0.3},
                       some_reflectance(random),
                       random.between(0, 1)};
    return material;
}

template <class Model>
void expect_few_as_each(const Model& model) {
    Random random(21);
    Lighting<float> lighting{Rgb<float>(0.1f), {}};
    lighting.lights.push_back(directional_light(Vec3<float>(1, 2, 3), Rgb<float>(0.7f)));
    lighting.lights.push_back(point_light(Vec3<float>(0.5f, 3, -1), Rgb<float>(0.9f, 0.5f, 0.3f)));
    const auto arriving = [](int i, std::size_t light, const Rgb<float>& term) {
        return i == 1 && light == 0 ? Rgb<float>(0.0f) : term;
    };
    for (int i = 0; i < 500; ++i) {
        std::vector<Surface<float>> surfaces;
        std::vector<Material<float>> materials;
        const int count = 1 + i % few;
        for (int k = 0; k < count; ++k) {
            const Vec3<float> point(random.in_cube(1));
            const Vec3<float> normal(random.unit_vector());
            surfaces.push_back({point, normal, Vec3<float>(random.unit_vector())});
            materials.push_back(some_material(random));
            materials.back().facets = materials.front().facets;
        }
        const auto surface_at = [&](int k) { return surfaces[static_cast<std::size_t>(k)]; };
        const auto material_at = [&](int k) { return materials[static_cast<std::size_t>(k)]; };
        int lit = 0;
        illuminate_few(
            model, places_of<float>(count, surface_at, material_at), lighting, arriving,
            [&](int k, const Rgb<float>& color) {
                const auto of_it = [&](std::size_t light, const Rgb<float>& term) {
                    return arriving(k, light, term);
                };
                ASSERT_EQ(color, illuminate(model, surface_at(k), material_at(k), lighting, of_it));
                ++lit;
            });
        ASSERT_EQ(lit, count);
    }
}

TEST(IlluminateFew, IsThatOfEach) {
    expect_few_as_each(Phong{});
    expect_few_as_each(CookTorrance{});
}

}  // namespace
}  // namespace scanlight::shading
