// The chapter's numbers on blending, refraction, Whitted's model and Hall's, named by their IDs.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "shading/blending.h"
#include "shading/illumination.h"
#include "shading/reflection.h"
#include "shading/refraction.h"
#include "shading/whitted.h"
#include "tests/shading/hemisphere.h"
#include "tests/shading/precision.h"

namespace scanlight::shading {
namespace {

template <class Real>
const Vec3<Real> z_axis{Real(0), Real(0), Real(1)};

TEST(Oracle, TRAN_a) {
    in_both_precisions([]<class Real>() {
        const Rgb<Real> I_a(Rgb<double>(0.8, 0.2, 0.1));
        const Rgb<Real> I_b(Rgb<double>(0.1, 0.5, 0.9));
        expect_value(blend(I_a, I_b, Real(0.3)), {0.59, 0.29, 0.34});
    });
}

template <class Real>
struct Pane {
    Real t, I;
};

template <class Real>
Rgb<Real> gray(Real value) {
    return Rgb<Real>(value);
}

template <class Real>
Rgb<Real> back_to_front(const Pane<Real>& front, const Pane<Real>& behind) {
    const Rgb<Real> through = blend(gray(behind.I), gray(Real(0.1)), behind.t);
    return blend(gray(front.I), through, front.t);
}

template <class Real>
Rgb<Real> front_to_back(const Pane<Real>& front, const Pane<Real>& behind) {
    const Layers<Real> first = with_pane_behind(Layers<Real>{}, gray(front.I), Real(1) - front.t);
    return before(with_pane_behind(first, gray(behind.I), Real(1) - behind.t), gray(Real(0.1)));
}

TEST(Oracle, TRAN_b_c) {
    in_both_precisions([]<class Real>() {
        const Pane<Real> one{Real(0.5), Real(0.8)};
        const Pane<Real> other{Real(0.25), Real(0.4)};
        expect_value(back_to_front(one, other), Rgb<double>(0.5625));
        expect_value(front_to_back(one, other), Rgb<double>(0.5625));
        expect_value(back_to_front(other, one), Rgb<double>(0.4125));
        expect_value(front_to_back(other, one), Rgb<double>(0.4125));
    });
}

TEST(Oracle, TRAN_d) {
    in_both_precisions([]<class Real>() {
        for (const double NV : {0.5, -0.5}) {
            const Real t = curved_transparency(Real(0.1), Real(0.6), static_cast<Real>(NV), 2);
            expect_value(t, 0.475);
        }
    });
}

TEST(Oracle, REFR_a) {
    in_both_precisions([]<class Real>() {
        expect_value(refracted(polar<Real>(30, 0), z_axis<Real>, Real(1.5)),
                     {-0.333333333, 0, -0.942809042});
    });
}

TEST(Oracle, REFR_b_c) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> V = polar<Real>(30, 0);
        const Vec3<Real> V_1 = V * (Real(1) / V.z);
        expect_value(whitted_factor(V_1, z_axis<Real>, Real(1.5)), 0.612372436);
        const Vec3<Real> T = whitted_refracted(V, z_axis<Real>, Real(1.5));
        expect_value(T, {-0.353553391, 0, -1});
        expect_value(glm::length(T), 1.06066017);
        expect_value(unit(T), {-0.333333333, 0, -0.942809042});
    });
}

/// From air into glass; the chapter's misprint of eta would give this for the way in.
TEST(Oracle, REFR_d) {
    in_both_precisions([]<class Real>() {
        expect_value(refracted(polar<Real>(30, 0), z_axis<Real>, Real(1) / Real(1.5)),
                     {-0.75, 0, -0.661437828});
    });
}

TEST(Oracle, REFR_e) {
    in_both_precisions([]<class Real>() {
        expect_value(refracted(along<Real>(-1, -1, 4), along<Real>(1, 1, 1), Real(1.33)),
                     {-0.103194796, -0.103194796, -0.98929352});
    });
}

TEST(Oracle, REFR_f) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> nowhere(Real(0));
        const Real eta = Real(1) / Real(1.5);
        EXPECT_EQ(refracted(polar<Real>(45, 0), z_axis<Real>, eta), nowhere);
        EXPECT_EQ(whitted_refracted(polar<Real>(45, 0), z_axis<Real>, eta), nowhere);
    });
}

TEST(Oracle, SDIR_a_b) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> V = along<Real>(-1, -1, 4);
        expect_value(reflected(V, z_axis<Real>), {0.23570226, 0.23570226, 0.942809042});
        expect_value(reflected(V, along<Real>(1, 1, 1)), {0.549971941, 0.549971941, -0.628539361});
    });
}

/// I_a K_a = 0.1, K_d I_p = 0.3, K_s I_p = 0.3, n = 20; N = z, L along (1,2,3), V along (-1,-1,4).
template <class Real>
Rgb<Real> local_light() {
    const Material<Real> material{.ambient = Rgb<Real>(Real(0.5)),
                                  .diffuse = Rgb<Real>(Real(0.3)),
                                  .specular = Rgb<Real>(Real(0.3)),
                                  .exponent = 20};
    const Surface<Real> surface{Vec3<Real>(Real(0)), z_axis<Real>, along<Real>(-1, -1, 4)};
    const auto light = directional_light(along<Real>(1, 2, 3), Rgb<Real>(Real(1)));
    return illuminate<Blinn>(surface, material, {Rgb<Real>(Real(0.2)), {light}});
}

TEST(Oracle, WHIT_a) {
    in_both_precisions([]<class Real>() {
        expect_value(whitted(local_light<Real>(), gray(Real(0.5)), gray(Real(0.2)), gray(Real(0.8)),
                             gray(Real(0.3))),
                     Rgb<double>(0.904489922));
    });
}

TEST(Oracle, WHIT_b) {
    in_both_precisions([]<class Real>() {
        expect_value(whitted_at_total_reflection(local_light<Real>(), gray(Real(0.5)),
                                                 gray(Real(0.2)), gray(Real(0.3))),
                     Rgb<double>(0.814489922));
    });
}

/// Below the surface, `theta` from -z towards -x, in degrees.
template <class Real>
Vec3<Real> below(double theta) {
    return -polar<Real>(theta, 0);
}

constexpr double refracted_30 = 19.471220634490695;  // asin(sin(30 degrees)/1.5)

TEST(Oracle, HALL_a) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> H_t =
            transmitting_normal(below<Real>(refracted_30), polar<Real>(30, 0), 1.5);
        expect_value(H_t, {0, 0, 1});
    });
}

TEST(Oracle, HALL_b_c) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> L = below<Real>(refracted_30 + 2);
        const Vec3<Real> V = polar<Real>(30, 0);
        expect_value(transmitting_normal(L, V, 1.5), {0.0921759977, 0, 0.995742731});
        expect_value(transmitted_highlight(z_axis<Real>, L, V, 1.5, 200), 0.426018936);
    });
}

TEST(Oracle, HALL_d) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> V = polar<Real>(20, 0);
        const Vec3<Real> L = refracted(V, z_axis<Real>, Real(1) / Real(1.5));
        expect_value(transmitting_normal(L, V, 1 / 1.5), {0, 0, 1});
    });
}

TEST(Oracle, HALL_e) {
    in_both_precisions([]<class Real>() {
        const Vec3<Real> V = polar<Real>(20, 0);
        const Vec3<Real> L = below<Real>(30.8658 + 2);
        expect_value(transmitting_normal(L, V, 1 / 1.5), {-0.0519718507, 0, 0.99864855});
        expect_value(transmitted_highlight(z_axis<Real>, L, V, 1 / 1.5, 200), 0.763018674);
    });
}

TEST(Oracle, HALL_f) {
    in_both_precisions([]<class Real>() {
        const Material<Real> shade{.ambient = Rgb<Real>(Real(0.5)),
                                   .diffuse = Rgb<Real>(Real(0.6)),
                                   .transmission = {.diffuse = Rgb<Real>(Real(0.5))}};
        const Surface<Real> surface{Vec3<Real>(Real(0)), z_axis<Real>, z_axis<Real>};
        const auto light = directional_light(-z_axis<Real>, Rgb<Real>(Real(0.7)));
        const Lighting<Real> lighting{Rgb<Real>(Real(0.2)), {light}};
        expect_value(illuminate<Hall>(surface, shade, lighting), Rgb<double>(0.45));
    });
}

}  // namespace
}  // namespace scanlight::shading
