// Textures: the chapter's oracles (specification §9), and laws on seeded random input.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "shading/bump.h"
#include "shading/mapping.h"
#include "shading/pattern.h"
#include "shading/sampling.h"
#include "shading/texture_lookup.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

using V = Vec3<double>;
using Spot = TextureSpot<double>;
constexpr double close = 1e-6;
constexpr double half_weight = 1.0 / 32768;  // weights of neighbours are 1/16384 apart

TexelImage image_of_oracle() {
    std::vector<float> rgba;
    for (const float grey : {0.0f, 1.0f, 0.5f, 0.25f})
        for (const float channel : {grey, grey, grey, 1.0f})
            rgba.push_back(channel);
    return {2, 2, rgba};
}

double looked_up(Wrap wrap, double u, double v) {
    const TexelImage image = image_of_oracle();
    return sampled<TexelColor<double>>(image, Filter::bilinear, wrap, Spot{u, v, 0.0}).x;
}

TEST(ImageTexture, IMAG) {
    EXPECT_NEAR(looked_up(Wrap::repeat, 0.375, 0.5), 0.34375, close);
    EXPECT_NEAR(looked_up(Wrap::clamp, 0.1, 0.2), 0.0, close);
    EXPECT_NEAR(looked_up(Wrap::repeat, 0.1, 0.2), 0.3125, half_weight);
}

TEST(ImageTexture, RepeatsEvery1AndMirrorsEvery2) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double u = random.between(-3, 3);
        const double v = random.between(-3, 3);
        ASSERT_NEAR(looked_up(Wrap::repeat, u, v), looked_up(Wrap::repeat, u + 2, v - 1), 1e-12);
        ASSERT_NEAR(looked_up(Wrap::mirror, u, v), looked_up(Wrap::mirror, -u, v + 2), 1e-12);
    }
}

TEST(ImageTexture, GivesATexelAtItsMiddleByEveryFilter) {
    const TexelImage image = image_of_oracle();
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
        EXPECT_EQ(sampled<TexelColor<double>>(image, filter, Wrap::clamp, Spot{0.75, 0.25, 0.5}).x,
                  1.0);
        EXPECT_EQ(sampled<TexelColor<double>>(image, filter, Wrap::clamp, Spot{0.25, 0.75, 0.5}).x,
                  0.5);
    }
}

TEST(ImageTexture, FromFarAwayIsItsMean) {
    const TexelImage image = image_of_oracle();
    ASSERT_EQ(image.levels(), 2);
    EXPECT_EQ(
        sampled<TexelColor<double>>(image, Filter::trilinear, Wrap::repeat, Spot{0.3, 0.9, 1e9}).x,
        0.4375);
    // Half way: a pixel of sqrt(2) texels.
    EXPECT_NEAR(
        sampled<TexelColor<double>>(image, Filter::trilinear, Wrap::clamp, Spot{0.75, 0.25, 2.0}).x,
        0.5 * (1.0 + 0.4375), close);
}

TexelImage image_of_noise(int width, int height) {
    Random random(6);
    std::vector<float> rgba;
    for (int i = 0; i < 4 * width * height; ++i)
        rgba.push_back(static_cast<float>(random.between(0, 1)));
    return {width, height, rgba};
}

TEST(ImageTexture, KeepsSharesInPairsToWithinATenthOfTheLeastSrgbStep) {
    Random random(7);
    std::vector<float> rgba{0.0f, 1.0f, 0.5f, 0x1p-14f};
    while (rgba.size() < 4 * 5)
        rgba.push_back(static_cast<float>(random.between(0, 1)));
    const TexelImage image(5, 1, rgba);
    ASSERT_EQ(image.format(), TexelImage::Format::pairs);
    EXPECT_EQ(image.unit(), 0x1p-14f);
    for (int x = 0; x < 5; ++x) {
        const auto texel = texel_at<TexelColor<float>, float>(image, image.index(x, 0));
        for (int c = 0; c < 3; ++c)
            EXPECT_LE(std::abs(texel[c] - rgba[static_cast<std::size_t>(4 * x + c)]), 0x1p-15f);
    }
    const auto first = texel_at<TexelColor<float>, float>(image, image.index(0, 0));
    EXPECT_EQ(first, Rgb<float>(0.0f, 1.0f, 0.5f));
    const auto alpha = texel_at<TexelAlpha<float>, float>(image, image.index(0, 0));
    EXPECT_EQ(alpha, 0x1p-14f);
}

/// What is brighter than white, or no number, is kept as 16-bit floats.
TEST(ImageTexture, LooksTheSameInHalves) {
    Random random(8);
    for (const float odd : {1.5f, -0.25f, std::nanf("")}) {
        std::vector<float> rgba;
        for (int i = 0; i < 4 * 8 * 4; ++i)
            rgba.push_back(static_cast<float>(random.between(0.25, 1)));
        const TexelImage pairs(8, 4, rgba);
        rgba.back() = odd;  // an alpha
        const TexelImage halves(8, 4, rgba);
        ASSERT_EQ(pairs.format(), TexelImage::Format::pairs);
        ASSERT_EQ(halves.format(), TexelImage::Format::halves);
        for (int i = 0; i < 500; ++i) {
            const double u = random.between(-2, 2);
            const double v = random.between(-2, 2);
            const Spot spot{u, v, std::exp2(random.between(-4, 6))};
            const auto wrap = static_cast<Wrap>(random.between(0, 3));
            const auto filter = static_cast<Filter>(random.between(0, 3));
            const auto a = sampled<TexelColor<double>>(pairs, filter, wrap, spot);
            const auto b = sampled<TexelColor<double>>(halves, filter, wrap, spot);
            ASSERT_LT(glm::length(a - b), 1e-3);
        }
    }
}

TEST(ImageTexture, LevelsKeepTheMeanOfSidesThatAreNoPowersOfTwo) {
    Random random(2);
    const int width = 13;
    const int height = 6;
    std::vector<float> rgba(4 * width * height);
    double mean = 0;
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        rgba[i] = static_cast<float>(random.between(0.1, 1));
        if (i % 4 == 0) mean += static_cast<double>(rgba[i]) / (width * height);
    }
    const TexelImage image(width, height, rgba);
    const auto far_away =
        sampled<TexelColor<double>>(image, Filter::trilinear, Wrap::repeat, Spot{0.5, 0.5, 1e12}).x;
    EXPECT_NEAR(far_away, mean, 5e-4);
}

TEST(ImageTexture, GoesOnInTheBordersOfItsLevelsAsIfItWereRepeated) {
    for (const glm::ivec2 size : {glm::ivec2(5, 3), glm::ivec2(1, 7), glm::ivec2(1, 1)}) {
        const TexelImage image = image_of_noise(size.x, size.y);
        for (int level = 0; level < image.levels(); ++level) {
            const int width = image.width(level);
            const int height = image.height(level);
            const auto at = [&](int x, int y) {
                const int stride = width + 2 * TexelImage::border;
                return texel_at<TexelColor<float>, float>(image,
                                                          image.begins()[level] + y * stride + x);
            };
            for (int y = -1; y <= height; ++y) {
                for (int x = -1; x <= width; ++x)
                    EXPECT_EQ(at(x, y), at((x + width) % width, (y + height) % height));
            }
        }
    }
}

Texture random_texture(Random& random) {
    Texture texture;
    texture.pattern = static_cast<Pattern>(random.between(0, 8));
    texture.mapping = static_cast<Mapping>(random.between(0, 5));
    texture.filter = static_cast<Filter>(random.between(0, 3));
    texture.wrap = static_cast<Wrap>(random.between(0, 3));
    texture.repeat = {random.between(-2, 2), 1.5f};
    texture.low = Rgb<float>(random.between(0, 1) < 0.5 ? 0.0f : 0.25f);
    if (random.between(0, 1) < 0.5) texture.pattern = Pattern::image;
    static const auto image = std::make_shared<const TexelImage>(image_of_noise(16, 8));
    texture.image = image;
    return texture;
}

Texture of_slopes(Texture texture) {
    static const auto slopes =
        std::make_shared<const TexelImage>(slopes_of(*texture.image, Wrap::repeat));
    texture.image = slopes;
    return texture;
}

/// Some see the texture from so near that a texel covers pixels, some from far away.
TextureSite<float> random_site(Random& random) {
    const auto vector = [&](double half_side) { return Vec3<float>(random.in_cube(half_side)); };
    const double size = std::exp2(random.between(-12, 0));
    const PixelSteps<Vec3<float>> steps{vector(size), vector(size)};
    const Vec3<float> point = vector(2);
    return {point,
            {point.x, point.z},
            PixelSteps<glm::vec<2, float>>{{steps.right.x, steps.right.z},
                                           {steps.down.x, steps.down.z}},
            UvGradients<float>{vector(1), vector(1)},
            steps};
}

TEST(Texture, OfAFewSitesIsThatOfEach) {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Texture texture = random_texture(random);
        const PlacedTexture placed{&texture, glm::mat4(1.0f)};
        const Texture heights = of_slopes(texture);
        const PlacedTexture bumps{&heights, glm::mat4(1.0f)};
        const int count = 1 + i % few;
        std::vector<TextureSite<float>> memory;
        for (int k = 0; k < count; ++k)
            memory.push_back(random_site(random));
        const Sites<float> sites = few_of(
            count, [&](int k) { return &std::as_const(memory[static_cast<std::size_t>(k)]); });
        const auto colors = colors_at(placed, sites);
        const auto gradients = height_gradients_at(bumps, sites);
        ASSERT_EQ(colors.count(), count);
        ASSERT_EQ(gradients.count(), count);
        for (int k = 0; k < count; ++k) {
            const auto one = one_site(memory[static_cast<std::size_t>(k)]);
            ASSERT_EQ(colors[k], colors_at(placed, one)[0]);
            ASSERT_EQ(gradients[k], height_gradients_at(bumps, one)[0]);
        }
    }
}

TEST(HalfFloat, KeepsWhatItHasAndRoundsTheRest) {
    for (const float value : {0.0f, 1.0f, -1.0f, 0.5f, 65504.0f, 0x1p-14f, 1.0f + 0x1p-10f})
        EXPECT_EQ(real_of_half<float>(half_from_float(value)), value);
    EXPECT_EQ(real_of_half<float>(half_from_float(1e9f)), 65504.0f);
    EXPECT_EQ(real_of_half<float>(half_from_float(std::nanf(""))), 0.0f);
    EXPECT_EQ(real_of_half<float>(half_from_float(1.0f + 0x1p-11f)), 1.0f);  // to even
    EXPECT_EQ(real_of_half<float>(half_from_float(1.0f + 0x1.8p-11f)), 1.0f + 0x1p-10f);
}

TEST(Checkerboard, CHEK) {
    const std::array<std::array<double, 3>, 5> expected{
        {{.1, .1, 1}, {.2, .1, 0}, {.2, .2, 1}, {.99, .99, 1}, {1, .5, 0}}};
    for (const auto& [u, v, g] : expected)
        EXPECT_EQ(checkerboard(u, v), g) << u << ", " << v;
}

TEST(Checkerboard, Has32DarkCells) {
    int dark = 0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            dark += checkerboard((i + 0.5) / 8, (j + 0.5) / 8) == 0.0 ? 1 : 0;
    EXPECT_EQ(dark, 32);
}

TEST(PlanarMapping, PLAN) {
    const PlanarMapping<double> a{{.5, 0, 0}, {0, .25, 0}, {0, 1, 0}};
    EXPECT_NEAR(a(V(1, 2, 7)).u, 0.5, close);
    EXPECT_NEAR(a(V(1, 2, 7)).v, 0.25, close);
    const PlanarMapping<double> b{{.1, .2, 0}, {0, -.1, .3}, {0, 0, 1}};
    EXPECT_NEAR(b(V(1, 2, 3)).u, 0.5, close);
    EXPECT_NEAR(b(V(1, 2, 3)).v, 0.4, close);
    EXPECT_NEAR(wrapped(b(V(9, -4, 3)).u, Wrap::repeat), 0.1, close);
    EXPECT_NEAR(std::remainder(wrapped(b(V(9, -4, 3)).v, Wrap::repeat), 1.0), 0.0, close);
}

TEST(CylindricalMapping, CYLI) {
    const std::array<std::array<double, 4>, 6> expected{{{.6, .8, 0.147583618, 0.333333333},
                                                         {-.6, -.8, 0.647583618, -0.333333333},
                                                         {0, 1, 0.25, 0},
                                                         {0, -1, 0.75, 0},
                                                         {1, 0, 0, 1},
                                                         {-1, 0, 0.5, -1}}};
    for (const auto& [x, y, u, half_tangent] : expected) {
        EXPECT_NEAR(CylindricalMapping<double>{}(V(x, y, 3)).u, u, close);
        EXPECT_NEAR(ChapterCylinderMapping<double>::half_tangent(x, y), half_tangent, close);
    }
    EXPECT_EQ(CylindricalMapping<double>{}(V(0, 0, 3)).u, 0.0);
    EXPECT_EQ((CylindricalMapping<double>{1, 4}(V(1, 0, 3)).v), 0.5);
}

TEST(SphericalMapping, SPHE) {
    const std::array<std::array<double, 5>, 4> expected{{{1, 2, 2, 0.176208191, 0.732279527},
                                                         {-1, 0, 1, 0.5, 0.75},
                                                         {0, -2, 0, 0.75, 0.5},
                                                         {0, 0, 3, 0, 1}}};
    for (const auto& [x, y, z, u, v] : expected) {
        EXPECT_NEAR(SphericalMapping{}(V(x, y, z)).u, u, close);
        EXPECT_NEAR(SphericalMapping{}(V(x, y, z)).v, v, close);
    }
}

template <class Mapping>
void expect_gradients(const Mapping& mapping) {
    constexpr double step = 1e-6;
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const V p{random.between(0.2, 1), random.between(0.2, 1), random.between(-1, 1)};
        const TexturePlace<double> place = mapping(p);
        for (int axis = 0; axis < 3; ++axis) {
            V q = p;
            q[axis] += step;
            ASSERT_NEAR(place.grad_u[axis], (mapping(q).u - place.u) / step, 2e-5);
            ASSERT_NEAR(place.grad_v[axis], (mapping(q).v - place.v) / step, 2e-5);
        }
    }
}

TEST(Mappings, KnowTheirGradients) {
    expect_gradients(PlanarMapping<double>{{.5, .3, 0}, {.1, .25, -2}, {0, 1, 0}});
    expect_gradients(CylindricalMapping<double>{-1, 2});
    expect_gradients(ChapterCylinderMapping<double>{-1, 2});
    expect_gradients(SphericalMapping{});
}

TEST(Wood, WOOD) {
    EXPECT_NEAR(ring_radius(V(30, 40, 75)), 50.3901785, close);
    EXPECT_NEAR(ring_radius(V(60, 0, 0)), 60, close);
    EXPECT_NEAR(ring_radius(V(-100, 20, 300)), 100.120928, 1e-5);
    EXPECT_NEAR(ring_radius(V(0, 38.5, 0)), 38.5, close);
    EXPECT_EQ(wood(V(30, 40, 75)), 0.0);
    EXPECT_EQ(wood(V(60, 0, 0)), 1.0);
    EXPECT_EQ(wood(V(-100, 20, 300)), 0.0);
    EXPECT_EQ(wood(V(0, 38.5, 0)), 1.0);
}

TEST(Noise, IsNothingAtTheLatticeSmoothAndNeitherBiasedNorConstant) {
    Random random(4);
    double sum = 0;
    double squares = 0;
    constexpr int trials = 20000;
    for (int i = 0; i < trials; ++i) {
        const V p{random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)};
        const double value = noise(p);
        sum += value;
        squares += value * value;
        ASSERT_LT(std::abs(value), 1.8);
        ASSERT_LT(std::abs(noise(p + V(1e-5, 0, 0)) - value), 1e-4);
    }
    EXPECT_EQ(noise(V(3, -7, 12)), 0.0);
    EXPECT_LT(std::abs(sum / trials), 0.02);
    EXPECT_GT(squares / trials, 0.02);
}

V plane_bump(double F_u, double F_v) {
    return wrinkled_normal(V(1, 0, 0), V(0, 1, 0), F_u, F_v, V(0, 0, 1));
}

TEST(Bump, BUMP) {
    const double F_u = 0.05 * 8 * pi * std::cos(8 * pi * 0.03);
    EXPECT_NEAR(F_u, 0.916048994, close);
    EXPECT_LT(glm::distance(plane_bump(F_u, 0), V(-0.675477095, 0, 0.737380969)), close);
    EXPECT_LT(glm::distance(plane_bump(.5, -.25), V(-0.43643578, 0.21821789, 0.872871561)), close);
    const double u = .5;
    const double v = 1;
    const V P_u = 2.0 * V(-std::cos(v) * std::sin(u), std::cos(v) * std::cos(u), 0);
    const V P_v = 2.0 * V(-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v));
    const V bumped = wrinkled_normal(P_u, P_v, 0.1 * 10 * std::cos(10 * u), 0.0, V(0, 0, 1));
    EXPECT_LT(glm::distance(bumped, V(0.5803484, 0.0277270847, 0.81389615)), close);
    const double cosine = glm::dot(bumped, V(0.5845364, 0.01645107, 0.8112007));
    EXPECT_NEAR(std::acos(cosine) * 180 / pi, 0.7063, 1e-3);
}

V random_vector(Random& random) {
    const double length = random.between(0.2, 3);
    return random.unit_vector() * length;
}

TEST(Bump, ByTheGradientIsBlinnsForm) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const V P_u = random_vector(random);
        const V P_v = random_vector(random);
        const V normal = glm::cross(P_u, P_v);
        if (glm::length(normal) < 0.05) continue;
        const V n = glm::normalize(normal);
        const double F_u = random.between(-1, 1);
        const double F_v = random.between(-1, 1);
        // On the surface du is what a step along P_u leaves and P_v does not.
        const V grad_u = glm::cross(P_v, n) / glm::dot(P_u, glm::cross(P_v, n));
        const V grad_v = glm::cross(n, P_u) / glm::dot(P_v, glm::cross(n, P_u));
        const V gradient = F_u * grad_u + F_v * grad_v + n * random.between(-1, 1);
        ASSERT_LT(glm::distance(bumped_normal(n, gradient), wrinkled_normal(P_u, P_v, F_u, F_v, n)),
                  1e-9);
    }
}

TEST(Bump, KeepsTheNormalAtAPole) {
    EXPECT_EQ(wrinkled_normal(V(0), V(0, 1, 0), 1.0, 1.0, V(0, 0, 1)), V(0, 0, 1));
}

TEST(NormalMap, AlongTheNormalChangesNothingAndLeansAlongU) {
    const TexturePlace<double> place{0, 0, V(2, 0, 0), V(0, 3, 0)};
    const V n(0, 0, 1);
    EXPECT_EQ(mapped_normal(n, V(0, 0, 1), place), n);
    EXPECT_LT(glm::distance(mapped_normal(n, V(.6, 0, .8), place), V(.6, 0, .8)), close);
    EXPECT_LT(glm::distance(mapped_normal(n, V(0, .6, .8), place), V(0, .6, .8)), close);
    const TexturePlace<double> mirrored{0, 0, V(-2, 0, 0), V(0, 3, 0)};
    EXPECT_LT(glm::distance(mapped_normal(n, V(.6, 0, .8), mirrored), V(-.6, 0, .8)), close);
}

TEST(Angles, AgreeWithTheLibrary) {
    Random random(6);
    for (int i = 0; i < 10000; ++i) {
        const double x = random.between(-2, 2);
        const double y = random.between(-2, 2);
        ASSERT_NEAR(turns_towards(y, x), std::atan2(y, x) / (2 * pi), 1e-15);
        ASSERT_NEAR(turns_towards(static_cast<float>(y), static_cast<float>(x)),
                    std::atan2(y, x) / (2 * pi), 1e-7);
        ASSERT_NEAR(sine_of_turns(x), std::sin(2 * pi * x), 2e-15);
        ASSERT_NEAR(sine_of_turns(static_cast<float>(x)),
                    std::sin(2 * pi * static_cast<double>(static_cast<float>(x))), 3e-7);
    }
}

}  // namespace
}  // namespace scanlight::shading
