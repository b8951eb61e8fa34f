#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace scanlight::bench {

/// What one benchmark came to: the median over its repetitions.
struct Median {
    double nanoseconds;
    double pixels;
};

/// Collects the medians in place of Google Benchmark's own table.
class Medians : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    const Median& operator[](const std::string& name) const { return medians_.at(name); }

private:
    std::map<std::string, Median> medians_;
};

/// Runs every registered benchmark `repetitions` times, in random order, so that a slow minute of
/// the machine falls on all of them alike. `json_path`, unless empty, gets every single run in
/// Google Benchmark's format. A benchmark's own name is its key.
Medians run_all(int repetitions, const std::string& json_path);

}  // namespace scanlight::bench
