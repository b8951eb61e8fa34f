#include "apps/scanlight/statistics.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace scanlight::apps {

namespace {

using Json = nlohmann::ordered_json;

double milliseconds(double seconds) {
    return seconds * 1e3;
}

Json json_of(const Statistics& s) {
    const auto& report = s.model.report;
    const auto& counts = s.counts;
    return {{"input", s.model.name},
            {"width", s.options.size.width},
            {"height", s.options.size.height},
            {"faces",
             {{"in_file", report.faces_in},
              {"zero_area", report.zero_area},
              {"few_corners", report.few_corners}}},
            {"vertices", s.model.mesh.vertices.size()},
            {"polygons",
             {{"in", counts.polygons},
              {"outside", counts.outside},
              {"culled", counts.culled},
              {"drawn", counts.drawn}}},
            {"spans", counts.spans},
            {"pixels", {{"tested", counts.pixels_tested}, {"passed", counts.pixels_passed}}},
            {"milliseconds",
             {{"load", milliseconds(s.model.load_seconds)},
              {"build", milliseconds(s.model.build_seconds)},
              {"draw", milliseconds(s.draw_seconds)},
              {"save", milliseconds(s.save_seconds)}}}};
}

/// A file's name need not be UTF-8.
std::string dumped(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Nested names joined by dots, one line a number.
std::string lines_of(const Json& json, const std::string& prefix) {
    std::string text;
    for (const auto& [key, value] : json.items()) {
        const std::string name = prefix.empty() ? key : prefix + "." + key;
        text += value.is_object() ? lines_of(value, name) : name + " " + dumped(value, -1) + "\n";
    }
    return text;
}

}  // namespace

std::string as_json(const Statistics& statistics) {
    return dumped(json_of(statistics), 2) + "\n";
}

std::string as_text(const Statistics& statistics) {
    return lines_of(json_of(statistics), "");
}

std::string summary(const std::string& output, const Statistics& s) {
    char text[200];
    std::snprintf(text, sizeof text, ": %dx%d, %zu of %zu polygons drawn in %.1f ms",
                  s.options.size.width, s.options.size.height, s.counts.drawn, s.counts.polygons,
                  milliseconds(s.draw_seconds));
    return output + text;
}

}  // namespace scanlight::apps
