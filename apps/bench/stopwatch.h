#pragma once

#include <benchmark/benchmark.h>
#include <time.h>

#include <string>

namespace scanlight::bench {

/// This thread's processor time in seconds: what other programs take in between does not count.
inline double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Registers `name` with Google Benchmark: the time of `job.draw()`, without `job.clear()` before
/// it. `job` is made by `make_job()` when its turn comes, and tells its `pixels()`.
template <class MakeJob>
void measure(const std::string& name, MakeJob make_job) {
    const auto run = [make_job](benchmark::State& state) {
        auto job = make_job();
        for (auto _ : state) {
            job.clear();
            const double begin = processor_time();
            job.draw();
            state.SetIterationTime(processor_time() - begin);
        }
        state.counters["pixels"] = static_cast<double>(job.pixels());
    };
    benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime();
}

}  // namespace scanlight::bench
