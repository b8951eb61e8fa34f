#include "shading/slopes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "shading/luminance.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

TexelImage heights(int width, int height, const std::function<double(int, int)>& at) {
    std::vector<float> rgba;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto grey = static_cast<float>(at(x, y));
            rgba.insert(rgba.end(), {grey, grey, grey, 1.0f});
        }
    }
    return TexelImage(width, height, rgba);
}

/// As smooth as repeats, along both sides.
TexelImage hills(int width, int height) {
    const double turn = 2 * std::numbers::pi;
    return heights(width, height, [=](int x, int y) {
        return 0.5 + 0.3 * std::sin(turn * x / width) + 0.15 * std::cos(2 * turn * y / height);
    });
}

Slopes<float> texel(const TexelImage& slopes, int x, int y) {
    return texel_at<TexelSlopes<float>, float>(slopes, slopes.index(x, y));
}

using Spot = TextureSpot<double>;

Slopes<double> slopes_at(const TexelImage& slopes, Filter filter, Wrap wrap, const Spot& spot) {
    return slopes_there(sampled<TexelSlopes<double>>(slopes, filter, wrap, spot), wrap, spot);
}

TEST(Slopes, OfARampAreItsStep) {
    const auto ramp = heights(9, 7, [](int x, int y) { return x / 16.0 - y / 32.0 + 0.5; });
    const auto slopes = slopes_of(ramp, Wrap::clamp);
    for (int x = 1; x < 8; ++x) {
        EXPECT_EQ(texel(slopes, x, 3).u, 1 / 16.0f);
        EXPECT_EQ(texel(slopes, x, 3).v, -1 / 32.0f);
    }
}

TEST(Slopes, HoweverFlatAreKeptAsFinely) {
    for (const float scale : {1e9f, 1.0f, 1e-3f, 1e-9f}) {
        const std::vector<float> numbers{7 * scale, -scale, scale, 0.0f};
        const TexelImage slopes = TexelImage::of_slopes(2, 1, numbers);
        EXPECT_EQ(slopes.format(), TexelImage::Format::pairs);
        EXPECT_NEAR(texel(slopes, 0, 0).u / scale, 7.0, 5e-4) << scale;
        EXPECT_NEAR(texel(slopes, 0, 0).v / scale, -1.0, 5e-4) << scale;
        EXPECT_NEAR(texel(slopes, 1, 0).u / scale, 1.0, 5e-4) << scale;
        EXPECT_EQ(texel(slopes, 1, 0).v, 0.0f);
    }
}

/// The largest number is 32767 units; one more takes a larger unit.
TEST(Slopes, HaveTheSmallestUnitInWhichTheyFit) {
    const auto unit_of = [](float largest) {
        return TexelImage::of_slopes(1, 1, std::vector<float>{0.0f, largest}).unit();
    };
    EXPECT_EQ(unit_of(32767.0f), 1.0f);
    EXPECT_EQ(unit_of(-32767.0f), 1.0f);
    EXPECT_EQ(unit_of(32767.002f), 2.0f);
    EXPECT_EQ(unit_of(1.0f), 0x1p-14f);
    const auto flat = TexelImage::of_slopes(1, 1, std::vector<float>{0.0f, 0.0f});
    EXPECT_EQ(texel(flat, 0, 0).u, 0.0f);
    EXPECT_EQ(texel(TexelImage::of_slopes(1, 1, std::vector<float>{0.0f, -32767.0f}), 0, 0).v,
              -32767.0f);
}

TEST(Slopes, AcrossAnEdgeAreThoseOfWhatGoesOnThere) {
    const auto ramp = heights(8, 1, [](int x, int) { return x / 8.0; });
    const auto repeated = slopes_of(ramp, Wrap::repeat);
    EXPECT_EQ(texel(repeated, 0, 0).u, 0.5f * (0.125f - 0.875f));
    EXPECT_EQ(texel(repeated, 7, 0).u, 0.5f * (0.0f - 0.75f));
    for (const Wrap wrap : {Wrap::clamp, Wrap::mirror}) {
        EXPECT_EQ(texel(slopes_of(ramp, wrap), 0, 0).u, 0.0f);
        EXPECT_EQ(texel(slopes_of(ramp, wrap), 7, 0).u, 0.0f);
        EXPECT_EQ(texel(slopes_of(ramp, wrap), 1, 0).u, 0.125f);
    }
}

/// What a bump map was before it had slopes: heights looked up one texel to each side.
TEST(Slopes, AreDifferencesOfTheHeightsBetweenTexelsToo) {
    const auto image = hills(64, 48);
    const auto slopes = slopes_of(image, Wrap::repeat);
    const auto height = [&](double u, double v) {
        return luminance(
            sampled<TexelColor<double>>(image, Filter::bilinear, Wrap::repeat, Spot{u, v, 0.0}));
    };
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const double u = random.between(-2, 3);
        const double v = random.between(-2, 3);
        const auto found = slopes_at(slopes, Filter::bilinear, Wrap::repeat, Spot{u, v, 0.0});
        ASSERT_NEAR(found.u, 0.5 * (height(u + 1.0 / 64, v) - height(u - 1.0 / 64, v)), 2e-5);
        ASSERT_NEAR(found.v, 0.5 * (height(u, v + 1.0 / 48) - height(u, v - 1.0 / 48)), 2e-5);
    }
}

TEST(Slopes, OfAMirrorImageFallWhereTheImageRises) {
    const auto slopes = slopes_of(hills(64, 48), Wrap::mirror);
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const double u = random.between(0.001, 0.999);
        const double v = random.between(0.001, 0.999);
        const auto at = [&](double x, double y) {
            return slopes_at(slopes, Filter::bilinear, Wrap::mirror, Spot{x, y, 0.0});
        };
        ASSERT_NEAR(at(2 - u, v).u, -at(u, v).u, 1e-9);
        ASSERT_NEAR(at(2 - u, v).v, at(u, v).v, 1e-9);
        ASSERT_NEAR(at(-u, 2 + v).u, -at(u, v).u, 1e-9);
        ASSERT_NEAR(at(u, -v).v, -at(u, v).v, 1e-9);
    }
}

TEST(Slopes, BeyondAnImageThatEndsAreNone) {
    const auto slopes = slopes_of(hills(16, 16), Wrap::clamp);
    for (const double u : {-3.0, -0.01, 1.01, 7.0})
        EXPECT_EQ(slopes_at(slopes, Filter::trilinear, Wrap::clamp, Spot{u, 0.3, 0.0}).u, 0.0);
}

TEST(Slopes, OfTheWholeImageTogetherAreNone) {
    const auto slopes = slopes_of(hills(64, 64), Wrap::repeat);
    const auto mean =
        sampled<TexelSlopes<double>>(slopes, Filter::trilinear, Wrap::repeat, Spot{0.5, 0.5, 1e9});
    EXPECT_NEAR(mean.u, 0.0, 1e-4);
    EXPECT_NEAR(mean.v, 0.0, 1e-4);
}

}  // namespace
}  // namespace scanlight::shading
