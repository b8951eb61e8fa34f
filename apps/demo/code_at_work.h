#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/demo/walk.h"

namespace scanlight::demo {

/// A function of the source as it was built, and which of its lines do a step.
struct Excerpt {
    std::string file;
    std::vector<std::string> lines;
    std::vector<std::size_t> at_work;  // places among the lines
};

/// The code that takes a step of this kind.
Excerpt code_at_work(WalkStep::Kind kind);

}  // namespace scanlight::demo
