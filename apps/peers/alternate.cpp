#include "apps/peers/alternate.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstddef>

namespace scanlight::peers {

namespace {

double seconds_once(const std::function<void()>& job, double seconds) {
    job();  // what the others have pushed out of the caches comes back
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    std::chrono::duration<double> elapsed{0.0};
    int times = 0;
    while (elapsed.count() < seconds) {
        job();
        ++times;
        elapsed = Clock::now() - begin;
    }
    return elapsed.count() / times;
}

}  // namespace

std::vector<Times> alternate(const std::vector<std::function<void()>>& jobs, int rounds,
                             double seconds) {
    std::vector<Times> times(jobs.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < jobs.size(); ++i)
            times[i].push_back(seconds_once(jobs[i], seconds));
    }
    return times;
}

double median(Times values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

Times ratios(const Times& slower, const Times& faster) {
    assert(slower.size() == faster.size());
    Times result;
    for (std::size_t i = 0; i < slower.size(); ++i)
        result.push_back(slower[i] / faster[i]);
    return result;
}

}  // namespace scanlight::peers
