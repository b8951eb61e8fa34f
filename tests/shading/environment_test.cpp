// Environment mapping: the chapter's oracles (specification §9, ENVM), and laws.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "shading/environment.h"
#include "shading/reflection.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

using V = Vec3<double>;
constexpr double close = 1e-6;

std::shared_ptr<const TexelImage> image(int width, int height, auto&& color_at) {
    std::vector<float> rgba;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 c = color_at((x + 0.5) / width, (y + 0.5) / height);
            for (int k = 0; k < 3; ++k)
                rgba.push_back(static_cast<float>(c[k]));
            rgba.push_back(1.0f);
        }
    }
    return std::make_shared<const TexelImage>(width, height, rgba);
}

TEST(EnvironmentMap, ENVM) {
    const V S = reflected(V(.5, 0, std::sqrt(.75)), V(0, 0, 1));
    EXPECT_LT(glm::distance(S, V(-0.5, 0, 0.866025404)), close);
    const auto latitudes = place_in(EnvironmentLayout::latitudes, S);
    EXPECT_NEAR(latitudes.u, 0.5, close);
    EXPECT_NEAR(latitudes.v, 0.833333333, close);
    const auto ball = place_in(EnvironmentLayout::sphere, glm::normalize(V(.2, .3, .9)));
    EXPECT_NEAR(ball.u, 0.55252138, close);
    EXPECT_NEAR(ball.v, 0.578782069, close);
    const auto cube = place_in(EnvironmentLayout::cube, V(.9, .2, -.3));
    EXPECT_EQ(cube.face, 0.0);
    EXPECT_NEAR(cube.u, 0.666666667, close);
    EXPECT_NEAR(cube.v, 0.388888889, close);
}

TEST(EnvironmentMap, LightThatGrowsWithHeightGivesTheChaptersIrradiance) {
    Environment environment;
    environment.images[0] =
        image(64, 512, [](double, double v) { return glm::dvec3(0.5 * (1.0 - std::cos(pi * v))); });
    Environment diffuse;
    diffuse.images[0] = diffuse_environment(environment, 32, 128);
    EXPECT_NEAR(light_from(diffuse, V(0, 0, 1)).x * pi, 2.61799388, 0.01);
    EXPECT_NEAR(light_from(diffuse, V(1, 0, 0)).x * pi, 1.57079633, 0.01);
    EXPECT_NEAR(light_from(diffuse, V(0, 0, -1)).x * pi, 0.523598776, 0.01);
}

TEST(Environment, TheDirectionOfAPlaceOnTheCubeIsFoundThere) {
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        const int face = i % 6;
        const double u = random.between(0.001, 0.999);
        const double v = random.between(0.001, 0.999);
        const auto place = place_on_cube(unit(direction_on_cube(face, u, v)));
        EXPECT_EQ(place.face, face);
        EXPECT_NEAR(place.u, u, 1e-12);
        EXPECT_NEAR(place.v, v, 1e-12);
    }
}

/// OpenGL's cube faces: what a direction through the middle of each texel finds is that texel.
TEST(EnvironmentMap, EachFaceOfACubeIsFoundWhereItIs) {
    Environment environment;
    environment.layout = EnvironmentLayout::cube;
    for (std::size_t face = 0; face < 6; ++face) {
        environment.images[face] = image(8, 8, [face](double u, double v) {
            return glm::dvec3(static_cast<double>(face), u, v);
        });
    }
    const V axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t face = 0; face < 6; ++face) {
        const V light = light_from(environment, axes[face]);
        EXPECT_NEAR(light.x, static_cast<double>(face), 1e-3);
        EXPECT_NEAR(light.y, 0.5, 1e-3);
        EXPECT_NEAR(light.z, 0.5, 1e-3);
    }
}

/// Seen by its own layout, each environment is the same.
TEST(EnvironmentMap, DirectionsKeepTheirLightInEveryLayout) {
    const auto colour = [](const V& d) { return glm::dvec3(0.5) + 0.4 * d; };
    Environment latitudes;
    latitudes.images[0] = image(256, 128, [&](double u, double v) {
        const double polar = pi * (v - 0.5);
        return colour({std::cos(polar) * std::cos(2 * pi * u),
                       std::cos(polar) * std::sin(2 * pi * u), std::sin(polar)});
    });
    Environment ball;
    ball.layout = EnvironmentLayout::sphere;
    ball.images[0] = image(512, 512, [&](double u, double v) {
        const V h(2 * u - 1, 2 * v - 1, 0);  // the ball's normal
        const double rest = 1 - glm::dot(h, h);
        const V n(h.x, h.y, std::sqrt(std::max(rest, 0.0)));
        return colour(rest > 0 ? 2.0 * n.z * n - V(0, 0, 1) : V(0, 0, -1));
    });
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const V d = random.unit_vector();
        ASSERT_LT(glm::distance(light_from(latitudes, d), colour(d)), 0.01);
        if (d.z > -0.9) {
            ASSERT_LT(glm::distance(light_from(ball, d), colour(d)), 0.01);
        }
    }
}

TEST(EnvironmentMap, TurnsWithItsAxes) {
    Environment environment;
    environment.images[0] = image(64, 32, [](double, double v) { return glm::dvec3(v); });
    environment.environment_from_world = glm::mat3(0, 1, 0, 0, 0, 1, 1, 0, 0);  // y up
    EXPECT_NEAR(light_from(environment, V(0, 1, 0)).x, 1.0, 0.02);
    EXPECT_NEAR(light_from(environment, V(0, -1, 0)).x, 0.0, 0.02);
    EXPECT_NEAR(light_from(environment, V(0, 0, 1)).x, 0.5, 0.02);
}

}  // namespace
}  // namespace scanlight::shading
