// The chapter's numbers on Fresnel's equations, microfacets and Cook and Torrance's model, named by
// their IDs. Inputs are exact; each is computed in double to 1e-6 and in float to 5e-5, relative.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shading/illumination.h"
#include "tests/shading/hemisphere.h"
#include "tests/shading/precision.h"

namespace scanlight::shading {
namespace {

constexpr double degree = 57.29577951308232;

template <class Real>
const Vec3<Real> z_axis{Real(0), Real(0), Real(1)};

template <class Real>
void expect_values(const std::vector<Real>& actual, const std::vector<double>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
        expect_value(actual[i], expected[i]);
}

template <class Real>
std::vector<Real> fresnel_at(std::initializer_list<double> degrees, double n) {
    std::vector<Real> result;
    for (const double theta : degrees)
        result.push_back(fresnel(cos_deg<Real>(theta), static_cast<Real>(n)));
    return result;
}

TEST(Oracle, FRES_a_b_c_d_e_f) {
    in_both_precisions([]<class Real>() {
        expect_values(fresnel_at<Real>({0, 30, 45, 60, 75, 89}, 1.5),
                      {0.04, 0.041522626, 0.050239911, 0.0891867128, 0.253060563, 0.90418495});
    });
}

TEST(Oracle, FRES_g) {
    in_both_precisions([]<class Real>() {
        const double brewster = std::atan(1.5);
        EXPECT_NEAR(brewster * degree, 56.3099325, 1e-6);
        expect_values(fresnel_at<Real>({brewster * degree}, 1.5), {0.073964497});
    });
}

TEST(Oracle, FRES_h) {
    in_both_precisions([]<class Real>() {
        expect_values(fresnel_at<Real>({30, 42}, 1 / 1.5), {0.0551901673, 1});
    });
    // So near total reflection, in float the rounding of the angle is magnified.
    expect_values(fresnel_at<double>({41}, 1 / 1.5), {0.379751266});
}

/// The index of gold, in red, green and blue.
const Reflectance gold = metal({0.21, 0.62, 1.38}, {3.272, 2.081, 1.914});

TEST(Oracle, FREM_a_b_c) {
    in_both_precisions([]<class Real>() {
        const auto at = [](double degrees) { return reflectance_at(cos_deg<Real>(degrees), gold); };
        expect_value(at(0), {0.930978291, 0.643419999, 0.408220334});
        expect_value(at(60), {0.9250179, 0.663374654, 0.439798667});
        expect_value(at(89), {0.991875074, 0.973893774, 0.943682766});
    });
}

TEST(Oracle, FREM_d) {
    expect_value(index_from_reflectance(0.95), 77.9871774);
    expect_value(index_from_reflectance(0.64), 9);
    expect_value(index_from_reflectance(0.35), 3.89725532);
}

TEST(Oracle, FREM_e) {
    in_both_precisions([]<class Real>() {
        const Reflectance material = metal_of_color({0.95, 0.64, 0.35});
        expect_value(reflectance_at(cos_deg<Real>(75), material),
                     {0.903460225, 0.526045881, 0.380130651});
    });
}

/// D at 0, 10 and 20 degrees.
template <class Real>
std::vector<Real> densities(const FacetSlopes& slopes) {
    return {facet_density(cos_deg<Real>(0), slopes), facet_density(cos_deg<Real>(10), slopes),
            facet_density(cos_deg<Real>(20), slopes)};
}

TEST(Oracle, DIST_a) {
    in_both_precisions([]<class Real>() {
        const FacetSlopes slopes(FacetDistribution::gauss, 0.3, FacetConstant::textbook);
        expect_values(densities<Real>(slopes), {1, 0.712864585, 0.258242762});
    });
}

TEST(Oracle, DIST_b) {
    const auto k = [](double m) { return FacetSlopes(FacetDistribution::gauss, m).constant(); };
    expect_value(k(0.2), 8.17222575);
    expect_value(k(0.3), 3.75411916);
    expect_value(1 / (pi * 0.2 * 0.2), 7.95774715);  // what k is about
    expect_value(1 / (pi * 0.3 * 0.3), 3.53677651);
}

TEST(Oracle, DIST_c) {
    in_both_precisions([]<class Real>() {
        const FacetSlopes slopes(FacetDistribution::beckmann, 0.3, FacetConstant::textbook);
        expect_values(densities<Real>(slopes), {11.1111111, 8.36221305, 3.27009298});
    });
}

TEST(Oracle, DIST_d) {
    in_both_precisions([]<class Real>() {
        const FacetSlopes slopes(FacetDistribution::beckmann, 0.3);
        expect_values(densities<Real>(slopes), {3.53677651, 2.66177508, 1.04090292});
    });
}

TEST(Oracle, DIST_e) {
    for (const double m : {0.2, 0.5})
        EXPECT_NEAR(projected_area(FacetSlopes(FacetDistribution::beckmann, m)), 1, 1e-6);
}

TEST(Oracle, DIST_f) {
    in_both_precisions([]<class Real>() {
        const FacetSlopes slopes(FacetDistribution::cosine, std::sqrt(2.0 / 52));
        EXPECT_NEAR(slopes.exponent().value(), 50, 1e-12);
        expect_value(facet_density(cos_deg<Real>(0), slopes), 8.27605704);
        expect_value(facet_density(cos_deg<Real>(10), slopes), 3.84942997);
    });
}

TEST(Oracle, DIST_g) {
    expect_value(rms_slope(std::array{0.1, 0.2, 0.3, 0.4}), 0.273861279);
}

template <class Real>
struct Geometry {
    Real G_m, G_s, G;
};

template <class Real>
Geometry<Real> geometry_of(const Vec3<Real>& L, const Vec3<Real>& V) {
    const Vec3<Real> H = half_vector(L, V);
    const Vec3<Real>& N = z_axis<Real>;
    const Real NH = dot(N, H);
    const Real VH = dot(V, H);
    return {groove_share(NH, dot(N, V), VH), groove_share(NH, dot(N, L), VH),
            facets_open(NH, dot(N, L), dot(N, V), VH)};
}

template <class Real>
void expect_geometry(const Vec3<Real>& L, const Vec3<Real>& V, const Geometry<double>& expected) {
    const Geometry<Real> actual = geometry_of(L, V);
    expect_value(actual.G_m, expected.G_m);
    expect_value(actual.G_s, expected.G_s);
    expect_value(actual.G, expected.G);
}

TEST(Oracle, GEOM_a_b_c_d_e) {
    in_both_precisions([]<class Real>() {
        const auto at = polar<Real>;
        expect_geometry(at(30, 0), at(30, 180), {2, 2, 1});
        expect_geometry(at(20, 0), at(85, 180), {0.241494958, 2.60374157, 0.241494958});
        expect_geometry(at(85, 0), at(20, 180), {2.60374157, 0.241494958, 0.241494958});
        expect_geometry(at(40, 0), at(70, 0), {0.406189978, 0.909769736, 0.406189978});
        expect_geometry(at(60, 0), at(70, 120), {0.753785152, 1.10196017, 0.753785152});
    });
}

/// N = z, L along (1,2,3), V along (-1,-1,4), m = 0.25, n = 1.5.
template <class Real>
struct Example {
    Vec3<Real> N = z_axis<Real>;
    Vec3<Real> L = along<Real>(1, 2, 3);
    Vec3<Real> V = along<Real>(-1, -1, 4);
    Vec3<Real> H = half_vector(L, V);
    Surface<Real> surface{Vec3<Real>(Real(0)), N, V};
    FacetSlopes slopes{FacetDistribution::beckmann, 0.25};
    FacetSlopes textbook_slopes{FacetDistribution::beckmann, 0.25, FacetConstant::textbook};
    Lighting<Real> light{Rgb<Real>(Real(0.1)), {directional_light(L, Rgb<Real>(Real(1)))}};
};

TEST(Oracle, COOK_a) {
    in_both_precisions([]<class Real>() {
        const auto& [N, L, V, H, surface, slopes, textbook_slopes, light] = Example<Real>();
        const auto degrees = [](Real cosine) {
            return static_cast<Real>(std::acos(static_cast<double>(cosine)) * degree);
        };
        expect_value(degrees(dot(N, H)), 9.77252757);
        expect_value(degrees(dot(V, H)), 27.7312081);
        expect_value(facet_density(dot(N, H), textbook_slopes), 10.5530106);
        expect_value(facets_open(dot(N, H), dot(N, L), dot(N, V), dot(V, H)), 1);
        expect_value(fresnel(dot(V, H), Real(1.5)), 0.0410764517);
    });
}

TEST(Oracle, COOK_b) {
    in_both_precisions([]<class Real>() {
        const auto& [N, L, V, H, surface, slopes, textbook_slopes, light] = Example<Real>();
        const Rgb<Real> textbook = cook_torrance(N, L, V, textbook_slopes, dielectric(1.5));
        const Rgb<Real> normalised = cook_torrance(N, L, V, slopes, dielectric(1.5));
        expect_value(textbook.x / dot(N, L), 0.182531763);
        expect_value(normalised.x / dot(N, L), 0.0456329407);
        expect_value(textbook.x / normalised.x, 4);
    });
}

TEST(Oracle, COOK_c) {
    in_both_precisions([]<class Real>() {
        const Example<Real> example;
        const Material<Real> plastic{.ambient = Rgb<Real>(Real(0.2)),
                                     .diffuse = Rgb<Real>(Real(0.5)),
                                     .facets = {example.slopes, dielectric(1.5), 0.4}};
        expect_value(illuminate<CookTorrance>(example.surface, plastic, example.light),
                     Rgb<double>(0.306512639));
    });
}

TEST(Oracle, COOK_d) {
    in_both_precisions([]<class Real>() {
        const Example<Real> example;
        const Material<Real> plate{
            .ambient = Rgb<Real>(Real(0)),
            .diffuse = Rgb<Real>(Real(0.5)),
            .facets = {example.slopes, metal_of_color({0.95, 0.64, 0.35}), 1}};
        expect_value(illuminate<CookTorrance>(example.surface, plate, example.light),
                     {2.6574112, 1.78753791, 0.979110822});
    });
}

TEST(Oracle, COOK_e) {
    in_both_precisions([]<class Real>() {
        const FacetSlopes slopes(FacetDistribution::beckmann, 0.25);
        const auto mirrored = [&](double theta) {
            return cook_torrance(z_axis<Real>, polar<Real>(theta, 0), polar<Real>(theta, 180),
                                 slopes, dielectric(1.5));
        };
        expect_value(mirrored(0).x, 0.0509295818);
        expect_value(mirrored(60).x, 0.227112099);
        expect_value(mirrored(80).x, 2.84276243);
        expect_value(mirrored(88).x, 29.8699218);
    });
}

TEST(Oracle, COOK_f) {
    const FacetSlopes slopes(FacetDistribution::beckmann, 0.3);
    const auto albedo = [&](double theta) { return albedo_of(slopes, polar<double>(theta, 0)); };
    EXPECT_NEAR(albedo(0), 0.9956, 0.003);
    EXPECT_NEAR(albedo(45), 0.9567, 0.003);
    EXPECT_NEAR(albedo(75), 0.9273, 0.003);
}

}  // namespace
}  // namespace scanlight::shading
