#pragma once

#include <string>

#include "apps/peers/contest.h"

namespace scanlight::peers {

/// What an outcome is of.
struct Entry {
    raster::Viewport size;
    int threads;
    std::string scene;
    std::size_t triangles;
    std::string shading;
};

/// The lines above a table.
std::string table_head(raster::Viewport size, int threads, const std::string& ours,
                       const std::string& theirs);

/// theirs / ours, round by round: the median. Requires times.
double median_ratio(const Outcome& outcome);

/// Medians, and the ratio theirs / ours: its median, lowest and highest over the rounds.
std::string table_line(const Entry& entry, const Outcome& outcome);

/// The geometric mean of so many scenes' ratios: of a ratio and its reciprocal it is 1.
std::string mean_line(const std::string& shading, const Times& ratios);

/// Everything, each round too, in one line of JSON.
std::string json_line(const Entry& entry, const Outcome& outcome);

}  // namespace scanlight::peers
