#include "apps/demo/code_at_work.h"

#include <gtest/gtest.h>

namespace scanlight::demo {
namespace {

TEST(CodeAtWork, IsAWholeFunctionWithItsLines) {
    using Kind = WalkStep::Kind;
    for (const Kind kind : {Kind::edge, Kind::scanline, Kind::pixel}) {
        const Excerpt excerpt = code_at_work(kind);
        EXPECT_EQ(excerpt.lines.back(), "}") << excerpt.file;
        EXPECT_FALSE(excerpt.lines.front().starts_with(" ")) << excerpt.file;
        EXPECT_FALSE(excerpt.at_work.empty()) << excerpt.file;
        EXPECT_GT(excerpt.lines.size(), 5u) << excerpt.file;
    }
}

TEST(CodeAtWork, OfAScanlineStepsTheActiveEdges) {
    const Excerpt excerpt = code_at_work(WalkStep::Kind::scanline);
    EXPECT_NE(excerpt.lines.at(excerpt.at_work.back()).find("active.step();"), std::string::npos);
}

}  // namespace
}  // namespace scanlight::demo
