#include "apps/bench/medians.h"

#include <string_view>

namespace scanlight::bench {

bool Medians::ReportContext(const Context&) {
    return true;
}

void Medians::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median") continue;
        medians_[run.run_name.function_name] = {run.GetAdjustedRealTime(),
                                                run.counters.at("pixels").value};
    }
}

Medians run_all(int repetitions, const std::string& json_path) {
    std::vector<std::string> options{
        "scanlight-bench", "--benchmark_enable_random_interleaving=true",
        "--benchmark_min_time=0.02", "--benchmark_repetitions=" + std::to_string(repetitions)};
    if (!json_path.empty()) {
        options.push_back("--benchmark_out=" + json_path);
        options.push_back("--benchmark_out_format=json");
    }
    std::vector<char*> arguments;
    for (std::string& option : options)
        arguments.push_back(option.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    Medians medians;
    benchmark::RunSpecifiedBenchmarks(&medians);
    return medians;
}

}  // namespace scanlight::bench
