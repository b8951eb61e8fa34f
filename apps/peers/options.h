#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "raster/project.h"

namespace scanlight::peers {

/// What both programs ask for.
struct Options {
    std::vector<raster::Viewport> sizes{{1920, 1080}};
    std::vector<int> threads{1, 2};
    int rounds = 7;
    std::string json_path;
};

void add_options(CLI::App& app, Options& options);

/// The exit status that `work` returns; 2 if it throws, after a message in the program's name.
int status_of(const std::string& program, const std::function<int()>& work);

}  // namespace scanlight::peers
