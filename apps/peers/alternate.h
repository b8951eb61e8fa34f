#pragma once

#include <functional>
#include <vector>

namespace scanlight::peers {

/// Seconds that each round took for one job, one after the other.
using Times = std::vector<double>;

/// Does the jobs in turns, a, b, c, a, b, c, …: a slow minute of the machine falls on all alike.
/// In each round each job is done again and again for at least `seconds`; its time is that of one,
/// by the clock on the wall. Once more it is done before the clock starts.
std::vector<Times> alternate(const std::vector<std::function<void()>>& jobs, int rounds,
                             double seconds);

/// Requires values.
double median(Times values);

/// slower / faster, round by round.
Times ratios(const Times& slower, const Times& faster);

}  // namespace scanlight::peers
