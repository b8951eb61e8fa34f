#pragma once

#include <cstddef>
#include <string>

#include "apps/scanlight/stopwatch.h"

namespace scanlight::apps {

/// A progress line on standard error, if that is a terminal and the work takes over a second.
class Progress {
public:
    Progress(std::string what, std::size_t steps);

    /// Before each step.
    void step(const std::string& name);

    /// Clears the line.
    void finish();

private:
    std::string what_;
    std::size_t steps_;
    std::size_t done_ = 0;
    double seconds_ = 0.0;
    bool is_terminal_;
    bool shown_ = false;
    Stopwatch stopwatch_;
};

}  // namespace scanlight::apps
