#include "apps/demo/window/frame_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace scanlight::apps::window {

double percentile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    const auto count = static_cast<double>(values.size());
    const double rank = std::clamp(std::ceil(share * count), 1.0, count);
    return values[static_cast<std::size_t>(rank) - 1];
}

std::string times_text(const std::string& what, const std::vector<double>& seconds) {
    double sum = 0.0;
    for (const double second : seconds)
        sum += second;
    std::array<char, 200> text;
    std::snprintf(text.data(), text.size(),
                  "%-8s p50 %5.2f ms   p95 %5.2f ms   p99 %5.2f ms   of %zu: %.0f a second",
                  what.c_str(), percentile(seconds, 0.5) * 1e3, percentile(seconds, 0.95) * 1e3,
                  percentile(seconds, 0.99) * 1e3, seconds.size(),
                  static_cast<double>(seconds.size()) / sum);
    return text.data();
}

}  // namespace scanlight::apps::window
