#include "apps/scanlight/frame_pattern.h"

#include <algorithm>

#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

bool is_width(const std::string& text) {
    return text.empty() || (text.size() == 2 && text[0] == '0' && text[1] >= '1' && text[1] <= '9');
}

}  // namespace

FramePattern::FramePattern(const std::string& text) {
    const std::size_t percent = text.find('%');
    const std::size_t letter = percent == std::string::npos ? percent : text.find('d', percent);
    const std::string width =
        letter == std::string::npos ? "?" : text.substr(percent + 1, letter - percent - 1);
    if (!is_width(width) || std::ranges::count(text, '%') != 1) {
        throw UsageError("output '" + text +
                         "': expected one %d or %0Nd for the frame's number, such as "
                         "frames/%04d.png; or a .gif, or -");
    }
    before_ = text.substr(0, percent);
    after_ = text.substr(letter + 1);
    digits_ = width.empty() ? 1 : width[1] - '0';
}

std::string FramePattern::name(int frame) const {
    const std::string number = std::to_string(frame);
    const auto missing = digits_ - static_cast<int>(number.size());
    return before_ + std::string(static_cast<std::size_t>(std::max(missing, 0)), '0') + number +
           after_;
}

}  // namespace scanlight::apps
