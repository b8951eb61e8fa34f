// The chapter's numbers, named by their IDs. Inputs are exact; each is computed in double to 1e-6
// and in float to 5e-5, relative.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "shading/illumination.h"
#include "shading/perception.h"
#include "shading/radiometry.h"
#include "shading/reflection.h"
#include "shading/refraction.h"
#include "tests/shading/precision.h"

namespace scanlight::shading {
namespace {

constexpr double degree = 57.29577951308232;

template <class Real>
const Vec3<Real> z_axis{Real(0), Real(0), Real(1)};

/// The chapter's running example: N = z, L along (1,2,3), V along (-1,-1,4).
template <class Real>
struct Example {
    Vec3<Real> N = z_axis<Real>;
    Vec3<Real> L = along<Real>(1, 2, 3);
    Vec3<Real> V = along<Real>(-1, -1, 4);
    Surface<Real> surface{Vec3<Real>(Real(0)), N, V};
};

template <class Real>
Material<Real> gray(double diffuse, double specular, double n) {
    return {.ambient = Rgb<Real>(Real(0.5)),
            .diffuse = Rgb<Real>(static_cast<Real>(diffuse)),
            .specular = Rgb<Real>(static_cast<Real>(specular)),
            .exponent = n};
}

template <class Real>
Light<Real> white_from(const Vec3<Real>& towards, double intensity = 1) {
    return directional_light(towards, Rgb<Real>(static_cast<Real>(intensity)));
}

/// I_a K_a = 0.1 with `gray`.
template <class Real>
Lighting<Real> lit_by(std::vector<Light<Real>> lights) {
    return {Rgb<Real>(Real(0.2)), std::move(lights)};
}

template <class Real>
double refracted_deg(double eta_1, double eta_2, double incident_deg) {
    const auto cosine = refracted_cosine(static_cast<Real>(eta_1), static_cast<Real>(eta_2),
                                         cos_deg<Real>(incident_deg));
    return std::acos(static_cast<double>(cosine.value())) * degree;
}

TEST(Oracle, REFL_a) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> L(Vec3<double>(0.6, 0, 0.8));
        expect_value(reflected(L, z_axis<Real>), {-0.6, 0, 0.8});
    });
}

TEST(Oracle, REFL_b_c_d) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> N = along<Real>(1, 1, 1);
        const Vec3<Real> L = along<Real>(1, 2, 3);
        const Vec3<Real> R = reflected(L, N);
        expect_value(R, {0.801783726, 0.534522484, 0.267261242});
        expect_value(dot(N, L), 0.9258201);
        expect_value(dot(N, R), 0.9258201);
        expect_value(dot(glm::cross(N, L), R), 0);
    });
}

TEST(Oracle, SNEL_a_b_d) {
    in_both_precisions([]<class Real>() {
        expect_value(static_cast<Real>(refracted_deg<Real>(1, 1.5, 30)), 19.4712206);
        expect_value(static_cast<Real>(refracted_deg<Real>(1.5, 1, 30)), 48.5903779);
        expect_value(static_cast<Real>(refracted_deg<Real>(1, 1.333, 60)), 40.5175906);
    });
}

TEST(Oracle, SNEL_c) {
    in_both_precisions([]<class Real>() {
        const double margin = 41.8103149 * tolerance<Real>;
        const auto at = [](double degrees) {
            return refracted_cosine(Real(1.5), Real(1), cos_deg<Real>(degrees));
        };
        EXPECT_TRUE(at(41.8103149 - margin).has_value());
        EXPECT_FALSE(at(41.8103149 + margin).has_value());
    });
}

TEST(Oracle, SNEL_e) {
    in_both_precisions([]<class Real>() {
        EXPECT_FALSE(refracted_cosine(Real(1.5), Real(1), cos_deg<Real>(45)).has_value());
    });
}

TEST(Oracle, ENRG_a) {
    in_both_precisions([]<class Real>() {
        expect_value(energy_left(Real(10), Real(4), Real(2.5), Real(1.5)), 2);
    });
}

TEST(Oracle, ENRG_b) {
    in_both_precisions([]<class Real>() {
        const auto left = [](double K_d) {
            return energy_left(Real(1), static_cast<Real>(K_d), Real(0.3), Real(0.2));
        };
        expect_value(left(0.5), 0);
        expect_value(left(0.6), -0.1);
    });
}

/// The exact solid angle of a square on the axis is the limit of the sum over its elements.
template <class Real>
Real square_solid_angle(double side, double distance) {
    constexpr int cells = 64;
    const double step = side / cells;
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const double x = (i + 0.5) * step - side / 2;
            const double y = (j + 0.5) * step - side / 2;
            const double r = std::sqrt(x * x + y * y + distance * distance);
            sum += static_cast<double>(solid_angle(static_cast<Real>(step * step),
                                                   static_cast<Real>(distance / r),
                                                   static_cast<Real>(r)));
        }
    }
    return static_cast<Real>(sum);
}

TEST(Oracle, SOLI_a_b) {
    EXPECT_NEAR(square_solid_angle<double>(1, 1), 0.805431683, 5e-5);  // of the sum, not of ds/r^2
    in_both_precisions(
        []<class Real>() { expect_value(square_solid_angle<Real>(0.1, 2), 0.00249843864); });
}

TEST(Oracle, SOLI_c) {
    in_both_precisions([]<class Real>() {
        expect_value(solid_angle(Real(0.01), cos_deg<Real>(60), Real(2)), 0.00125);
    });
}

TEST(Oracle, SOLI_d) {
    in_both_precisions(
        []<class Real>() { expect_value(cone_solid_angle(cos_deg<Real>(10)), 0.0954557031); });
}

TEST(Oracle, FLUX_a) {
    in_both_precisions([]<class Real>() { expect_value(isotropic_flux(Real(100)), 1256.63706); });
}

TEST(Oracle, FLUX_b) {
    in_both_precisions([]<class Real>() {
        expect_value(irradiance(Real(100), cos_deg<Real>(60), Real(2)), 12.5);
    });
}

TEST(Oracle, FLUX_c) {
    in_both_precisions(
        []<class Real>() { expect_value(intensity_of(Real(1.5), Real(0.06), Real(1.5)), 56.25); });
}

template <class Real>
Real ten_at(Falloff falloff, double r) {
    const DistanceLaw<Real> law{.falloff = falloff, .k = Real(1)};
    return Real(10) * share_at(law, static_cast<Real>(r));
}

TEST(Oracle, FALL_a) {
    in_both_precisions([]<class Real>() {
        expect_value(ten_at<Real>(Falloff::inverse, 4), 2.5);
        expect_value(ten_at<Real>(Falloff::inverse_square, 4), 0.625);
        expect_value(ten_at<Real>(Falloff::inverse_plus_k, 4), 2);
    });
}

TEST(Oracle, FALL_b) {
    in_both_precisions([]<class Real>() {
        expect_value(ten_at<Real>(Falloff::inverse, 0.5), 20);
        expect_value(ten_at<Real>(Falloff::inverse_square, 0.5), 40);
        expect_value(ten_at<Real>(Falloff::inverse_plus_k, 0.5), 6.66666667);
    });
}

TEST(Oracle, FALL_c) {
    in_both_precisions(
        []<class Real>() { expect_value(ten_at<Real>(Falloff::inverse_plus_k, 0), 10); });
}

template <class Real>
Vec3<Real> tilted(double degrees) {
    return Vec3<Real>(Vec3<double>(std::sin(radians(degrees)), 0, std::cos(radians(degrees))));
}

TEST(Oracle, LAMB_a_b) {
    in_both_precisions([]<class Real>() {
        expect_value(Real(0.7) * lambert(z_axis<Real>, tilted<Real>(30)), 0.606217783);
        expect_value(Real(0.7) * lambert(z_axis<Real>, tilted<Real>(90)), 0);
        EXPECT_EQ(lambert(z_axis<Real>, tilted<Real>(120)), Real(0));
    });
}

TEST(Oracle, LAMB_c) {
    in_both_precisions([]<class Real>() {
        const Example<Real> example;
        Lighting<Real> lighting =
            lit_by<Real>({white_from(example.L), white_from(along<Real>(-2, 1, 1), 0.5)});
        lighting.ambient = Rgb<Real>(Real(0));
        expect_value(illuminate<Lambert>(example.surface, gray<Real>(0.6, 0, 1), lighting).x,
                     0.603544723);
    });
}

TEST(Oracle, AMBI_a_b) {
    in_both_precisions([]<class Real>() {
        expect_value(ambient(Rgb<Real>(Real(0.2)), Rgb<Real>(Real(0.5))), Vec3<double>(0.1));
        expect_value(
            ambient(Rgb<Real>(Vec3<double>(0.2, 0.3, 0.4)), Rgb<Real>(Vec3<double>(0.5, 0.1, 1))),
            {0.1, 0.03, 0.4});
    });
}

TEST(Oracle, PHON_a_b) {
    in_both_precisions([]<class Real>() {
        const auto [N, L, V, surface] = Example<Real>{};
        const Vec3<Real> H = half_vector(L, V);
        expect_value(dot(N, L), 0.801783726);
        expect_value(dot(N, V), 0.942809042);
        expect_value(dot(reflected(L, N), V), 0.944911183);
        expect_value(dot(N, H), 0.985489398);
        expect_value(H, {0.0178271069, 0.168798225, 0.985489398});
    });
}

TEST(Oracle, PHON_c) {
    in_both_precisions([]<class Real>() {
        const auto [N, L, V, surface] = Example<Real>{};
        const Vec3<Real> H = half_vector(L, V);
        expect_value(phong(N, L, V, 20), 0.321973237);
        expect_value(blinn(N, L, H, 20), 0.746516015);
        expect_value(blinn(N, L, H, 80), 0.310567865);
    });
}

TEST(Oracle, PHON_d_e) {
    in_both_precisions([]<class Real>() {
        const Example<Real> example;
        const Material<Real> material = gray<Real>(0.6, 0.4, 20);
        const Lighting<Real> lighting = lit_by<Real>({white_from(example.L)});
        expect_value(illuminate<Phong>(example.surface, material, lighting).x, 0.70985953);
        expect_value(illuminate<Blinn>(example.surface, material, lighting).x, 0.879676641);
    });
}

TEST(Oracle, PHON_f) {
    in_both_precisions([]<class Real>() {
        const Material<Real> material = gray<Real>(0.6, 0.4, 20);
        const Lighting<Real> lighting = lit_by<Real>({white_from(along<Real>(1, 2, -3))});
        expect_value(illuminate<Phong>(Example<Real>{}.surface, material, lighting).x, 0.1);
    });
}

TEST(Oracle, EXPO_a_b) {
    in_both_precisions([]<class Real>() {
        expect_value(power(cos_deg<Real>(10), 50), 0.465128497);
        expect_value(power(cos_deg<Real>(5), 50), 0.826439946);
        expect_value(power(cos_deg<Real>(5), 200), 0.466493078);
        expect_value(power(cos_deg<Real>(9.5183455), 50), 0.5);
    });
}

template <class Real>
struct ColoredExample : Example<Real> {
    Material<Real> material{.ambient = Rgb<Real>(Vec3<double>(0.2, 0.3, 0.4)),
                            .diffuse = Rgb<Real>(Vec3<double>(0.7, 0.5, 0.3)),
                            .specular = Rgb<Real>(Real(0.4)),
                            .exponent = 30};
    Lighting<Real> first{Rgb<Real>(Vec3<double>(0.1, 0.1, 0.15)),
                         {directional_light(this->L, Rgb<Real>(Vec3<double>(1, 0.9, 0.8)))}};
    Lighting<Real> both{
        first.ambient,
        {first.lights[0],
         directional_light(along<Real>(-2, 1, 1), Rgb<Real>(Vec3<double>(0.2, 0.3, 0.6)))}};
};

TEST(Oracle, RGBP_a) {
    in_both_precisions([]<class Real>() {
        const ColoredExample<Real> example;
        expect_value(illuminate<Blinn>(example.surface, example.material, example.both),
                     {0.896458864, 0.684323527, 0.532480607});
    });
}

TEST(Oracle, RGBP_b) {
    in_both_precisions([]<class Real>() {
        const ColoredExample<Real> example;
        expect_value(illuminate<Blinn>(example.surface, example.material, example.first),
                     {0.839248001, 0.623002131, 0.458827609});
    });
}

TEST(Oracle, RGBP_c) {
    in_both_precisions([]<class Real>() {
        const ColoredExample<Real> example;
        expect_value(illuminate<Phong>(example.surface, example.material, example.both),
                     {0.711481873, 0.517810574, 0.38437559});
    });
}

TEST(Oracle, FLAT_b) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> facet = unit(glm::cross(Vec3<Real>(2, 0, 0), Vec3<Real>(0, 3, 1)));
        expect_value(facet, {0, -0.316227766, 0.948683298});  // FLAT.a
        Surface<Real> surface = Example<Real>{}.surface;
        surface.normal = facet;
        const Lighting<Real> lighting = lit_by<Real>({white_from(along<Real>(1, 2, 3))});
        expect_value(illuminate<Lambert>(surface, gray<Real>(0.6, 0, 1), lighting).x, 0.454964787);
    });
}

TEST(Oracle, MACH_a_b) {
    in_both_precisions([]<class Real>() {
        const double facets[] = {1, 0.965925826, 0.866025404, 0.707106781, 0.5};
        const double steps[] = {0.0340741737, 0.0999004225, 0.158918623, 0.207106781};
        const auto facet = [](int i) { return lambert(tilted<Real>(15 * i), z_axis<Real>); };
        for (int i = 0; i < 5; ++i)
            expect_value(facet(i), facets[i]);
        for (int i = 0; i < 4; ++i)
            expect_value(facet(i) - facet(i + 1), steps[i]);
    });
}

TEST(Oracle, MACH_c) {
    in_both_precisions([]<class Real>() {
        std::vector<Real> step(16, Real(0.4));
        for (std::size_t i = 8; i < 16; ++i)
            step[i] = Real(0.6);
        const std::vector<Real> seen = lateral_inhibition<Real>(step);
        const double expected[] = {0.4, 0.38, 0.36, 0.64, 0.62, 0.6};
        for (std::size_t i = 0; i < 6; ++i)
            expect_value(seen[5 + i], expected[i]);
    });
}

template <class Real>
Real gouraud_at(double r) {
    const auto [N, L, V, surface] = Example<Real>{};
    return Real(0.1) + Real(0.6) * gouraud_1971(N, L, static_cast<Real>(r), Real(1));
}

TEST(Oracle, GORG_a_b_c) {
    in_both_precisions([]<class Real>() {
        expect_value(gouraud_at<Real>(4), 0.196214047);
        expect_value(gouraud_at<Real>(9), 0.148107024);
        expect_value(gouraud_at<Real>(0), 0.581070235);
    });
}

TEST(Oracle, GORG_a_AsAModelWithALampFourAway) {
    in_both_precisions([]<class Real>() {
        const Example<Real> example;
        const Lighting<Real> lighting =
            lit_by<Real>({point_light(example.L * Real(4), Rgb<Real>(Real(1)))});
        const Material<Real> material = gray<Real>(0.6, 0.4, 20);
        expect_value(illuminate<Gouraud1971>(example.surface, material, lighting).x, 0.196214047);
    });
}

/// L = V = z, I_a K_a = .1, K_d = .5, K_s = .4, n = 50.
template <class Real>
Real lit_from_the_eye(const Vec3<Real>& normal) {
    const Surface<Real> surface{Vec3<Real>(Real(0)), normal, z_axis<Real>};
    const Lighting<Real> lighting = lit_by<Real>({white_from(z_axis<Real>)});
    return illuminate<Blinn>(surface, gray<Real>(0.5, 0.4, 50), lighting).x;
}

TEST(Oracle, PHSH_f) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> interpolated(Vec3<double>(0.0538016029, 0, 0.863104256));
        expect_value(lit_from_the_eye(unit(interpolated)), 0.962070851);
    });
}

TEST(Oracle, PHSH_g) {
    in_both_precisions([]<class Real>() {
        expect_value(lit_from_the_eye(z_axis<Real>), 1);
        expect_value(lit_from_the_eye(along<Real>(-1, 0, 1)), 0.453553403);
        expect_value(lit_from_the_eye(along<Real>(1, 0, 1)), 0.453553403);
    });
}

template <class Real>
Real half_diffuse_half_specular(const Vec3<Real>& normal) {
    const Surface<Real> surface{Vec3<Real>(Real(0)), normal, z_axis<Real>};
    const Lighting<Real> lighting{Rgb<Real>(Real(0)), {white_from(z_axis<Real>)}};
    return illuminate<Blinn>(surface, gray<Real>(0.5, 0.5, 50), lighting).x;
}

TEST(Oracle, HILI_a_b) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> left = tilted<Real>(-30);
        const Vec3<Real> right = tilted<Real>(30);
        const Real gouraud =
            (half_diffuse_half_specular(left) + half_diffuse_half_specular(right)) / Real(2);
        expect_value(gouraud, 0.433388974);
        expect_value(half_diffuse_half_specular(unit(left + right)), 1);
    });
}

}  // namespace
}  // namespace scanlight::shading
