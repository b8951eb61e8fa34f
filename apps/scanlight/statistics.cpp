#include "apps/scanlight/statistics.h"

#include "apps/scanlight/process_memory.h"
#include "apps/scanlight/text_table.h"
#include "apps/scene/json.h"
#include "apps/scene/words.h"

namespace scanlight::apps {

namespace {

double milliseconds(double seconds) {
    return seconds * 1e3;
}

/// Seven digits are more than a clock is worth.
Json time_json(double seconds) {
    return json_number(static_cast<float>(milliseconds(seconds)));
}

bool is_fast(const Statistics& s) {
    return s.picture.path == DrawPath::fast;
}

/// A number that only the fast path has.
template <class Number>
Json fast_only(const Statistics& s, const Number& number) {
    return is_fast(s) ? Json(number) : Json();
}

Json means_json(const Statistics& s) {
    return {{"path", word_of(s.picture.path)},
            {"threads", s.picture.threads},
            {"instructions", fast_only(s, s.picture.instructions)}};
}

Json input_json(const Statistics& s) {
    const auto [report, vertices, load, build] = totals_of(s.models);
    return {{"faces",
             {{"in_file", report.faces_in},
              {"zero_area", report.zero_area},
              {"few_corners", report.few_corners}}},
            {"vertices", vertices}};
}

Json counts_json(const render::DrawCounts& counts) {
    return {{"polygons",
             {{"in", counts.polygons},
              {"outside", counts.outside},
              {"culled", counts.culled},
              {"drawn", counts.drawn}}},
            {"spans", counts.spans},
            {"pixels",
             {{"tested", counts.pixels_tested},
              {"passed", counts.pixels_passed},
              {"shaded", counts.pixels_shaded}}}};
}

/// Drawing takes the four stages that follow it, and what comes before and after them.
Json times_json(const Statistics& s) {
    const auto& stages = s.picture.drawing.seconds;
    const ModelTotals totals = totals_of(s.models);
    return {{"load", time_json(totals.load_seconds)},
            {"build", time_json(totals.build_seconds)},
            {"draw", time_json(s.draw_seconds)},
            {"vertices", fast_only(s, time_json(stages.vertices))},
            {"bins", fast_only(s, time_json(stages.bins))},
            {"shadows", fast_only(s, time_json(stages.shadows))},
            {"bands", fast_only(s, time_json(stages.bands))},
            {"save", time_json(s.save_seconds)}};
}

Json memory_json(const Statistics& s) {
    return {{"working_bytes", fast_only(s, s.picture.drawing.working_bytes)},
            {"peak_bytes", peak_memory()}};
}

double megapixels(raster::Viewport size) {
    return static_cast<double>(size.width) * size.height / 1e6;
}

Json json_of(const Statistics& s) {
    Json json{{"input", s.options.input},
              {"width", s.options.size.width},
              {"height", s.options.size.height},
              {"megapixels", megapixels(s.options.size)}};
    json.update(means_json(s));
    json.update(input_json(s));
    json.update(counts_json(s.picture.drawing.counts));
    json["milliseconds"] = times_json(s);
    json["memory"] = memory_json(s);
    return json;
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
    const auto& counts = s.picture.drawing.counts;
    if (counts.polygons == 0) return "no polygon to draw";
    return std::to_string(counts.drawn) + " of " + std::to_string(counts.polygons) +
           " polygons drawn in " + fixed(milliseconds(s.draw_seconds), 1) + " ms";
}

std::string left_out_text(const Statistics& s) {
    const auto report = totals_of(s.models).report;
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
