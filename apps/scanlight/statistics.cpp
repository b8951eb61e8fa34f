#include "apps/scanlight/statistics.h"

#include "apps/scanlight/json.h"
#include "apps/scanlight/text_table.h"

namespace scanlight::apps {

namespace {

double milliseconds(double seconds) {
    return seconds * 1e3;
}

/// Seven digits are more than a clock is worth.
Json time_json(double seconds) {
    return json_number(static_cast<float>(milliseconds(seconds)));
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
             {{"load", time_json(s.model.load_seconds)},
              {"build", time_json(s.model.build_seconds)},
              {"draw", time_json(s.draw_seconds)},
              {"save", time_json(s.save_seconds)}}}};
}

/// Nested names joined by dots, one line a number.
std::string lines_of(const Json& json, const std::string& prefix) {
    std::string text;
    for (const auto& [key, value] : json.items()) {
        const std::string name = prefix.empty() ? key : prefix + "." + key;
        text += value.is_object() ? lines_of(value, name) : name + " " + json_text(value);
    }
    return text;
}

std::string drawn_text(const Statistics& s) {
    if (s.counts.polygons == 0) return "no polygon to draw";
    return std::to_string(s.counts.drawn) + " of " + std::to_string(s.counts.polygons) +
           " polygons drawn in " + fixed(milliseconds(s.draw_seconds), 1) + " ms";
}

std::string left_out_text(const Statistics& s) {
    const auto& report = s.model.report;
    if (report.faces_in == 0) return ", as the file has no faces";
    const std::size_t left_out = report.faces_in - report.drawn;
    if (left_out == 0) return "";
    return ", " + std::to_string(left_out) + " of the file's " + std::to_string(report.faces_in) +
           " faces left out";
}

}  // namespace

std::string as_json(const Statistics& statistics) {
    return json_text(json_of(statistics));
}

std::string as_text(const Statistics& statistics) {
    return lines_of(json_of(statistics), "");
}

std::string summary(const std::string& output, const Statistics& s) {
    return output + ": " + std::to_string(s.options.size.width) + "x" +
           std::to_string(s.options.size.height) + ", " + drawn_text(s) + left_out_text(s);
}

}  // namespace scanlight::apps
