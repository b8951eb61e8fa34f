#include "shading/blending.h"

#include <gtest/gtest.h>

#include <vector>

#include <glm/geometric.hpp>

#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

struct Pane {
    Rgb<double> I;
    double t;
};

/// Front to back.
std::vector<Pane> random_panes(Random& random) {
    std::vector<Pane> panes(static_cast<std::size_t>(random.between(0, 9)));
    for (Pane& pane : panes) {
        pane.I = random.color();
        pane.t = random.between(0, 1);
    }
    return panes;
}

Rgb<double> back_to_front(const std::vector<Pane>& panes, Rgb<double> light) {
    for (auto pane = panes.rbegin(); pane != panes.rend(); ++pane)
        light = blend(pane->I, light, pane->t);
    return light;
}

Layers<double> front_to_back(const std::vector<Pane>& panes) {
    Layers<double> layers;
    for (const Pane& pane : panes)
        layers = with_pane_behind(layers, pane.I, 1.0 - pane.t);
    return layers;
}

TEST(Blend, OfAClearPaneShowsWhatIsBehindAndOfAnOpaqueOneThePane) {
    const Rgb<float> front(0.1f, 0.7f, 3.0f);
    const Rgb<float> behind(0.3f, 0.2f, 0.9f);
    EXPECT_EQ(blend(front, behind, 1.0f), behind);
    EXPECT_EQ(blend(front, behind, 0.0f), front);
}

TEST(Blend, LiesBetweenItsColors) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Rgb<double> a = random.color();
        const Rgb<double> b = random.color();
        const Rgb<double> mixed = blend(a, b, random.between(0, 1));
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(mixed[k], std::min(a[k], b[k]) - 1e-15);
            ASSERT_LE(mixed[k], std::max(a[k], b[k]) + 1e-15);
        }
    }
}

TEST(Layers, FrontToBackIsBackToFront) {
    Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const std::vector<Pane> panes = random_panes(random);
        const Rgb<double> background = random.color();
        const Rgb<double> difference =
            before(front_to_back(panes), background) - back_to_front(panes, background);
        ASSERT_NEAR(glm::length(difference), 0, 1e-14);
    }
}

TEST(Layers, BehindAnOpaquePaneNothingShows) {
    Random random(3);
    std::vector<Pane> panes = random_panes(random);
    panes.push_back({Rgb<double>(0.5), 0});
    const Layers<double> layers = front_to_back(panes);
    EXPECT_EQ(layers.transparency, Rgb<double>(0));
    EXPECT_EQ(before(layers, Rgb<double>(0)), before(layers, Rgb<double>(1)));
}

TEST(Layers, StainedGlassFiltersWhatIsBehindItAndNotItsOwnLight) {
    const Rgb<double> red(1, 0.5, 0);
    const auto glass = with_pane_behind(Layers<double>{}, Rgb<double>(0.2), 0.25, red);
    EXPECT_EQ(glass.light, Rgb<double>(0.05));
    EXPECT_EQ(before(glass, Rgb<double>(1)), Rgb<double>(0.8, 0.425, 0.05));
    const auto two = with_pane_behind(glass, Rgb<double>(0.4), 0.5, Rgb<double>(0, 1, 1));
    EXPECT_EQ(two.light, glass.light + red * (0.75 * 0.5 * 0.4));
    EXPECT_EQ(two.transparency, Rgb<double>(0, 0.1875, 0));
}

TEST(Layers, TheirOrderMatters) {
    const Pane red{{1, 0, 0}, 0.5};
    const Pane blue{{0, 0, 1}, 0.5};
    const Rgb<double> background(0.2);
    EXPECT_NE(back_to_front({red, blue}, background), back_to_front({blue, red}, background));
}

TEST(CurvedTransparency, FallsFromTheMiddleToTheOutline) {
    EXPECT_EQ(curved_transparency(0.1, 0.6, 0.0, 3), 0.1);
    EXPECT_EQ(curved_transparency(0.1, 0.6, 1.0, 3), 0.6);
    double before = 0;
    for (double NV = 0.01; NV <= 1; NV += 0.01) {
        const double t = curved_transparency(0.1, 0.6, NV, 3);
        ASSERT_GT(t, before);
        ASSERT_EQ(t, curved_transparency(0.1, 0.6, -NV, 3));
        before = t;
    }
}

}  // namespace
}  // namespace scanlight::shading
