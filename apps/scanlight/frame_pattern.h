#pragma once

#include <string>

namespace scanlight::apps {

/// The names of numbered files: "frames/%04d.png". It holds one %d or %0Nd, N from 1 to 9, and no
/// other %.
class FramePattern {
public:
    /// Throws UsageError for any other text.
    explicit FramePattern(const std::string& text);

    /// The name of a frame, from 0.
    std::string name(int frame) const;

private:
    std::string before_, after_;
    int digits_ = 1;  // at least
};

}  // namespace scanlight::apps
