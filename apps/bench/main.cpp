#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <string>

#include "apps/bench/frames.h"
#include "apps/bench/spans.h"

namespace {

struct Options {
    int repetitions = 9;
    std::string json_path;
};

void add_options(CLI::App& command, Options& options) {
    command.add_option("--repetitions", options.repetitions, "Runs to take the median of")
        ->check(CLI::Range(3, 1000))
        ->capture_default_str();
    command.add_option("--json", options.json_path, "Write every run to this file");
}

int run(int argc, char** argv) {
    using namespace scanlight::bench;
    CLI::App app("What it costs to give each pixel its value");
    app.require_subcommand(1);
    Options options;
    auto* interpolation = app.add_subcommand(
        "interpolation", "Incremental interpolation against working out each pixel anew");
    auto* frames = app.add_subcommand("frames", "The same over whole pictures, and whole frames");
    add_options(*interpolation, options);
    add_options(*frames, options);
    CLI11_PARSE(app, argc, argv);
    const auto compare = interpolation->parsed() ? compare_interpolations : compare_frames;
    compare(options.repetitions, options.json_path);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "scanlight-bench: " << error.what() << '\n';
        return 1;
    }
}
