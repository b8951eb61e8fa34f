#pragma once

#include <string>
#include <vector>

namespace scanlight::apps::window {

/// The least of the values such that this share of them, 0 to 1, is no more; of at least one value.
double percentile(std::vector<double> values, double share);

/// "frame: p50 8.1 ms, p95 9.7 ms, p99 11.0 ms, of 300 frames: 123 a second"
std::string times_text(const std::string& what, const std::vector<double>& seconds);

}  // namespace scanlight::apps::window
