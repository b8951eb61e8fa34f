#include "apps/demo/window/frame_times.h"

#include <gtest/gtest.h>

namespace scanlight::apps::window {
namespace {

TEST(FrameTimes, PercentilesAreOfTheNearestRank) {
    const std::vector<double> values{5.0, 1.0, 4.0, 2.0, 3.0};
    EXPECT_EQ(percentile(values, 0.5), 3.0);
    EXPECT_EQ(percentile(values, 0.2), 1.0);
    EXPECT_EQ(percentile(values, 0.21), 2.0);
    EXPECT_EQ(percentile(values, 0.99), 5.0);
    EXPECT_EQ(percentile({7.0}, 0.0), 7.0);
}

}  // namespace
}  // namespace scanlight::apps::window
