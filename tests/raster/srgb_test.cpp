#include "raster/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace scanlight::raster {
namespace {

long double decoded(long double srgb) {
    return srgb <= 0.04045L ? srgb / 12.92L : powl((srgb + 0.055L) / 1.055L, 2.4L);
}

TEST(Srgb, StepsAtTheFirstFloatBeyondEachOfThe255Boundaries) {
    for (int v = 0; v < 255; ++v) {
        const long double boundary = decoded((v + 0.5L) / 255);
        float above = static_cast<float>(boundary);
        if (above < boundary) above = std::nextafter(above, 2.0f);
        const float below = std::nextafter(above, 0.0f);
        ASSERT_LT(below, boundary);
        EXPECT_EQ(srgb_from_linear(above), v + 1) << v;
        EXPECT_EQ(srgb_from_linear(below), v) << v;
    }
}

TEST(Srgb, NeverFallsAsLightGrows) {
    int last = 0;
    const auto end = std::bit_cast<std::uint32_t>(1.0f) + 1000;
    for (std::uint32_t bits = 0; bits < end; bits += 97) {
        const int value = srgb_from_linear(std::bit_cast<float>(bits));
        ASSERT_TRUE(value == last || value == last + 1) << bits;
        last = value;
    }
    EXPECT_EQ(last, 255);
}

TEST(Srgb, ClampsWhatIsNotALightBetweenZeroAndOne) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float dark : {0.0f, -0.0f, -1.0f, -1e-30f, -infinity, nan, -nan, 1e-40f}) {
        EXPECT_EQ(srgb_from_linear(dark), 0) << dark;
    }
    for (const float bright : {1.0f, std::nextafter(1.0f, 2.0f), 17.0f, 3e38f, infinity}) {
        EXPECT_EQ(srgb_from_linear(bright), 255) << bright;
    }
}

TEST(Srgb, DecodesToTheNearestFloat) {
    for (int v = 0; v < 256; ++v) {
        EXPECT_EQ(linear_from_srgb(static_cast<std::uint8_t>(v)),
                  static_cast<float>(decoded(v / 255.0L)))
            << v;
    }
}

TEST(Srgb, EncodesWhatItDecoded) {
    for (int v = 0; v < 256; ++v) {
        EXPECT_EQ(srgb_from_linear(linear_from_srgb(static_cast<std::uint8_t>(v))), v);
    }
}

}  // namespace
}  // namespace scanlight::raster
