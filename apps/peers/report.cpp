#include "apps/peers/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace scanlight::peers {

namespace {

std::string size_text(raster::Viewport size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string agreement_text(const Agreement& agreement) {
    return formatted("%5zu of %6zu  %5.3f", agreement.only_one, agreement.outline,
                     agreement.color_difference);
}

std::string times_text(const Outcome& outcome) {
    const Times ratio = ratios(outcome.theirs, outcome.ours);
    const auto [lowest, highest] = std::ranges::minmax(ratio);
    return formatted("%9.2f %12.2f %7.2f  (%5.2f to %5.2f)", 1e3 * median(outcome.ours),
                     1e3 * median(outcome.theirs), median(ratio), lowest, highest);
}

}  // namespace

double median_ratio(const Outcome& outcome) {
    return median(ratios(outcome.theirs, outcome.ours));
}

std::string table_head(raster::Viewport size, int threads, const std::string& ours,
                       const std::string& theirs) {
    return formatted("\n%s, %d thread%s: Scanlight by %s, %s\n", size_text(size).c_str(), threads,
                     threads == 1 ? "" : "s", ours.c_str(), theirs.c_str()) +
           formatted("%-22s %9s  %-13s %9s %12s %7s  %-16s  %s\n", "scene", "triangles", "shading",
                     "ours, ms", "llvmpipe, ms", "ratio", "over the rounds",
                     "pixels that only one covers, of the outline; colours differ by, 1/255");
}

std::string table_line(const Entry& entry, const Outcome& outcome) {
    const std::string begin = formatted("%-22s %9zu  %-13s ", entry.scene.c_str(), entry.triangles,
                                        entry.shading.c_str());
    const std::string pictures = agreement_text(outcome.agreement) + "\n";
    if (outcome.ours.empty()) return begin + "THE PICTURES DISAGREE  " + pictures;
    return begin + times_text(outcome) + "  " + pictures;
}

std::string mean_line(const std::string& shading, const Times& ratios) {
    double logarithms = 0.0;
    for (const double ratio : ratios)
        logarithms += std::log(ratio);
    return formatted("%-22s %9zu  %-13s %9s %12s %7.2f\n", "mean of so many scenes", ratios.size(),
                     shading.c_str(), "", "",
                     std::exp(logarithms / static_cast<double>(ratios.size())));
}

std::string json_line(const Entry& entry, const Outcome& outcome) {
    nlohmann::ordered_json json{{"width", entry.size.width},
                                {"height", entry.size.height},
                                {"threads", entry.threads},
                                {"scene", entry.scene},
                                {"triangles", entry.triangles},
                                {"shading", entry.shading},
                                {"seconds_ours", outcome.ours},
                                {"seconds_llvmpipe", outcome.theirs},
                                {"covered", outcome.agreement.covered},
                                {"covered_by_one", outcome.agreement.only_one},
                                {"outline", outcome.agreement.outline},
                                {"color_difference", outcome.agreement.color_difference}};
    if (!outcome.ours.empty()) json["ratio"] = median_ratio(outcome);
    return json.dump() + "\n";
}

}  // namespace scanlight::peers
