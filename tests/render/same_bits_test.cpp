#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <ostream>
#include <set>
#include <string>

#include "tests/raster/cases.h"
#include "tests/render/scenes.h"
#include "tests/same_bits/ways.h"

namespace scanlight::same_bits {

void PrintTo(const NamedScene& scene, std::ostream* out) {
    *out << scene.name;
}

namespace {

/// All ways in a fast build; in a slow one each instruction set with threads that change places.
std::vector<render::Renderer>& fast_ways() {
    static constexpr int three[] = {3};
    static std::vector<render::Renderer> ways =
        raster::laws::thorough ? renderers(thread_counts) : renderers(three);
    return ways;
}

/// Nothing if all pixels have the same bits.
template <class T>
std::string difference(const raster::Plane<T>& a, const raster::Plane<T>& b) {
    const auto width = static_cast<std::size_t>(a.width());
    std::size_t count = 0;
    std::string first;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        if (std::memcmp(&a.values()[i], &b.values()[i], sizeof(T)) == 0) continue;
        if (count++ == 0) first = std::to_string(i % width) + ", " + std::to_string(i / width);
    }
    return count == 0 ? "" : std::to_string(count) + " pixels, the first at (" + first + ")";
}

void expect_same_counts(const render::DrawCounts& walk, const render::DrawCounts& fast) {
    EXPECT_EQ(walk.polygons, fast.polygons);
    EXPECT_EQ(walk.outside, fast.outside);
    EXPECT_EQ(walk.culled, fast.culled);
    EXPECT_EQ(walk.drawn, fast.drawn);
    EXPECT_GE(walk.pixels_tested, fast.pixels_tested);  // what is hidden whole is not tested
    EXPECT_EQ(walk.pixels_passed, fast.pixels_passed);
}

class SameBits : public testing::TestWithParam<NamedScene> {
protected:
    const TestScene test = GetParam().make();
    const render::Drawing walk = draw(test);
};

TEST_P(SameBits, FastPathDrawsWhatTheScanlineWalkDraws) {
    for (render::Renderer& renderer : fast_ways()) {
        SCOPED_TRACE(name_of(renderer));
        const render::Drawing fast = draw(test, renderer);
        EXPECT_EQ(difference(walk.framebuffer.color, fast.framebuffer.color), "");
        EXPECT_EQ(difference(walk.framebuffer.depth, fast.framebuffer.depth), "");
        expect_same_counts(walk.counts, fast.counts);
    }
}

void expect_same_stencils(const std::vector<render::Stencil>& expected,
                          const std::vector<render::Stencil>& stencils) {
    ASSERT_EQ(expected.size(), stencils.size());
    for (std::size_t light = 0; light < expected.size(); ++light)
        EXPECT_EQ(difference(expected[light], stencils[light]), "") << "light " << light;
}

TEST_P(SameBits, FastPathCountsTheShadowVolumesThatTheScanlineWalkCounts) {
    const auto expected = count_shadows(test);
    for (render::Renderer& renderer : fast_ways()) {
        SCOPED_TRACE(name_of(renderer));
        expect_same_stencils(expected, count_shadows(test, renderer));
    }
}

/// From the eye, beginning with what the near plane cuts open, and from infinity.
TEST_P(SameBits, ShadowVolumesAreCountedAlikeFromBothEnds) {
    if (test.settings.shadows == render::Shadows::none) return;
    expect_same_stencils(count_shadows(test, render::Shadows::zpass),
                         count_shadows(test, render::Shadows::zfail));
}

raster::Plane<raster::PackedPixel> packed(const raster::Plane<raster::Rgba>& colors,
                                          raster::Encoding encoding) {
    raster::Plane<raster::PackedPixel> pixels({colors.width(), colors.height()}, 0);
    render::for_each_pixel({colors.width(), colors.height()}, [&](int x, int y) {
        pixels.at(x, y) = raster::packed_pixel(colors.at(x, y), encoding);
    });
    return pixels;
}

TEST_P(SameBits, BytesAreThoseOfTheFloats) {
    static constexpr int two[] = {2};
    static std::vector<render::Renderer> ways = renderers(two);
    for (const auto encoding : {raster::Encoding::srgb, raster::Encoding::linear}) {
        const auto expected = packed(walk.framebuffer.color, encoding);
        for (render::Renderer& renderer : ways) {
            SCOPED_TRACE(name_of(renderer));
            raster::Plane<raster::PackedPixel> pixels(test.size, 0x12345678);
            raster::Plane<raster::Depth> depth(test.size, -7);
            renderer.draw(test.scene, test.settings, pixels, encoding, &depth);
            EXPECT_EQ(difference(expected, pixels), "");
            EXPECT_EQ(difference(walk.framebuffer.depth, depth), "");
        }
    }
}

/// What is not a number has no bits to rely on.
TEST_P(SameBits, PicturesHoldNumbersOnly) {
    for (const raster::Rgba& color : walk.framebuffer.color.values()) {
        for (const float channel : {color.r, color.g, color.b, color.a})
            ASSERT_TRUE(std::isfinite(channel));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits, testing::ValuesIn(all_scenes()), [](const auto& info) {
    std::string name = info.param.name;
    std::ranges::replace_if(
        name, [](char c) { return !std::isalnum(c); }, '_');
    return name;
});

TEST(SameBitsScenes, HaveNamesOfTheirOwnAndPolygonsInSight) {
    std::set<std::string> names;
    std::size_t shown = 0;
    for (const auto& [name, make] : all_scenes()) {
        EXPECT_TRUE(names.insert(name).second) << name;
        shown += draw(make()).counts.pixels_passed > 0 ? 1 : 0;
    }
    EXPECT_GE(shown, names.size() - 8);  // "nothing", sheets seen from the culled side
    EXPECT_GE(shown, 60u);
}

}  // namespace
}  // namespace scanlight::same_bits
