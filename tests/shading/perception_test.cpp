#include "shading/perception.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace scanlight::shading {
namespace {

TEST(LateralInhibition, LeavesEvenLightAsItIs) {
    for (const std::size_t length : {1u, 2u, 3u, 50u}) {
        const std::vector<double> seen =
            lateral_inhibition<double>(std::vector<double>(length, 0.7));
        ASSERT_EQ(seen.size(), length);
        for (const double intensity : seen)
            EXPECT_NEAR(intensity, 0.7, 1e-15);
    }
}

TEST(LateralInhibition, OfNothingIsNothing) {
    EXPECT_TRUE(lateral_inhibition<float>({}).empty());
}

TEST(LateralInhibition, LeavesAnEvenSlopeAsItIsButBendsAtItsBreak) {
    std::vector<double> profile;
    for (int i = 0; i < 20; ++i)
        profile.push_back(std::min(i, 10) * 0.05);
    const std::vector<double> seen = lateral_inhibition<double>(profile);
    EXPECT_NEAR(seen[5], profile[5], 1e-15);
    EXPECT_GT(seen[10], profile[10] + 0.01);  // the bright Mach band of a Gouraud edge
    EXPECT_NEAR(seen[15], profile[15], 1e-15);
}

}  // namespace
}  // namespace scanlight::shading
