#include "apps/scanlight/steps_report.h"

#include <algorithm>

#include "apps/scanlight/text_table.h"
#include "apps/scene/words.h"

namespace scanlight::apps {

namespace {

using raster::Trace;
using render::PolygonSteps;
using Row = std::vector<std::string>;

// ---- text

std::string corner_name(std::uint32_t corner) {
    return "P" + std::to_string(corner);
}

std::uint32_t end_corner(const PolygonSteps& steps, const Trace::Edge& edge) {
    return (edge.index + 1) % static_cast<std::uint32_t>(steps.corners.size());
}

std::string edge_name(const PolygonSteps& steps, const Trace::Edge& edge) {
    return corner_name(edge.index) + "-" + corner_name(end_corner(steps, edge));
}

/// A value and its increment for each thing interpolated, depth last.
void append_numbers(Row& row, const Trace::Numbers& item) {
    for (std::size_t k = 0; k < item.values.size(); ++k) {
        row.push_back(fixed(item.values[k], 4));
        row.push_back(fixed(item.steps[k], 5));
    }
    row.push_back(fixed(item.z, 4));
    row.push_back(fixed(item.dz, 5));
}

Row value_names(const PolygonSteps& steps) {
    Row names;
    for (const auto& name : steps.names) {
        names.push_back(name);
        names.push_back("Δ" + name);
    }
    names.push_back("z");
    names.push_back("Δz");
    return names;
}

Row joined(Row a, const Row& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::string corners_text(const PolygonSteps& steps) {
    TextTable table(joined({"corner", "x", "y"}, joined(steps.names, {"z"})));
    for (std::size_t i = 0; i < steps.corners.size(); ++i) {
        const auto& corner = steps.corners[i];
        Row row{corner_name(static_cast<std::uint32_t>(i)), fixed(corner.x, 3), fixed(corner.y, 3)};
        for (const double value : corner.values)
            row.push_back(fixed(value, 4));
        row.push_back(fixed(corner.z, 4));
        table.add_row(row);
    }
    return "Corners (pixels; y grows downward)\n" + table.text("  ");
}

Row edge_row(const PolygonSteps& steps, const Trace::Edge& edge) {
    Row row{edge_name(steps, edge), std::to_string(edge.y_end - 1), fixed(edge.x, 3),
            fixed(edge.dx, 4)};
    append_numbers(row, edge);
    return row;
}

Row edge_header(const PolygonSteps& steps) {
    return joined({"edge", "y_max", "x", "Δx"}, value_names(steps));
}

std::string edge_table_text(const PolygonSteps& steps) {
    TextTable table(joined({"bucket"}, edge_header(steps)));
    int bucket = -1;
    for (const auto& edge : steps.trace.edge_table) {
        const std::string label = edge.y_begin == bucket ? "" : "y " + std::to_string(edge.y_begin);
        table.add_row(joined({label}, edge_row(steps, edge)));
        bucket = edge.y_begin;
    }
    return "Edge table (each edge waits in the bucket of its first scanline; values at that "
           "line)\n" +
           table.text("  ");
}

std::string active_text(const PolygonSteps& steps, const Trace::Scanline& line) {
    TextTable table(edge_header(steps));
    for (const auto& edge : line.active)
        table.add_row(edge_row(steps, edge));
    return table.text("  ");
}

std::string spans_text(const PolygonSteps& steps, const Trace::Scanline& line) {
    if (line.spans.empty()) return "  no pixel centre between them\n";
    TextTable table(joined({"span", "pixels"}, value_names(steps)));
    for (const auto& span : line.spans) {
        Row row{"x " + std::to_string(span.x_begin) + "-" + std::to_string(span.x_end - 1),
                std::to_string(span.x_end - span.x_begin)};
        append_numbers(row, span);
        table.add_row(row);
    }
    return table.text("  ");
}

// ---- JSON

/// "I_r q" is the key I_r_q.
std::string key_of(std::string name) {
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// What is stepped is exact: in full, so that a value and its increments add up.
Json values_json(const std::vector<std::string>& names, const std::vector<double>& values) {
    Json json = Json::object();
    for (std::size_t k = 0; k < names.size(); ++k)
        json[key_of(names[k])] = values[k];
    return json;
}

void put_numbers(Json& json, const PolygonSteps& steps, const Trace::Numbers& item) {
    json["z"] = item.z;
    json["dz"] = item.dz;
    json["values"] = values_json(steps.names, item.values);
    json["increments"] = values_json(steps.names, item.steps);
}

Json edge_json(const PolygonSteps& steps, const Trace::Edge& edge) {
    Json json{{"from", edge.index},
              {"to", end_corner(steps, edge)},
              {"y_begin", edge.y_begin},
              {"y_end", edge.y_end},
              {"x", edge.x},
              {"dx", edge.dx}};
    put_numbers(json, steps, edge);
    return json;
}

Json span_json(const PolygonSteps& steps, const Trace::Span& span) {
    Json json{{"x_begin", span.x_begin}, {"x_end", span.x_end}};
    put_numbers(json, steps, span);
    return json;
}

Json scanline_json(const PolygonSteps& steps, const Trace::Scanline& line) {
    Json active = Json::array();
    Json spans = Json::array();
    for (const auto& edge : line.active)
        active.push_back(edge_json(steps, edge));
    for (const auto& span : line.spans)
        spans.push_back(span_json(steps, span));
    return {{"y", line.y}, {"active", active}, {"spans", spans}};
}

/// What a corner carries are floats; its place is exact, in 1/256 pixel.
Json corner_json(const PolygonSteps& steps, const PolygonSteps::Corner& corner) {
    const auto number = [](double value) { return json_number(static_cast<float>(value)); };
    Json values = Json::object();
    for (std::size_t k = 0; k < steps.names.size(); ++k)
        values[key_of(steps.names[k])] = number(corner.values[k]);
    return {{"x", corner.x}, {"y", corner.y}, {"z", number(corner.z)}, {"values", values}};
}

Json point_json(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

Json view_json(const StepsSource& source) {
    const SceneOptions& options = source.options;
    const std::string projection = word_of(options.projection);
    if (!options.eye) {
        return {{"projection", projection},
                {"azimuth_deg", options.view.azimuth_deg},
                {"elevation_deg", options.view.elevation_deg}};
    }
    return {{"projection", projection},
            {"eye", point_json(source.camera.eye)},
            {"target", point_json(source.camera.target)}};
}

Json header_json(const StepsSource& source, const std::vector<PolygonSteps>& polygons) {
    const SceneOptions& options = source.options;
    Json numbers = Json::array();
    for (const auto& steps : polygons)
        numbers.push_back(steps.id);
    return {{"scanlight", SCANLIGHT_VERSION},
            {"input", options.input},
            {"size", {{"width", options.size.width}, {"height", options.size.height}}},
            {"view", view_json(source)},
            {"polygons_seen", source.polygons_seen},
            {"polygon_numbers", numbers},
            {"shading", word_of(options.settings.shading)},
            {"illumination", word_of(options.settings.illumination)},
            {"interpolation", word_of(options.polygons)},
            {"perspective", word_of(options.settings.perspective)}};
}

// ---- grey

bool is_grey(const std::vector<double>& v) {
    return v[0] == v[1] && v[0] == v[2];
}

template <class Items>
bool all_grey(const Items& items) {
    for (const auto& item : items) {
        if (!is_grey(item.values) || !is_grey(item.steps)) return false;
    }
    return true;
}

bool has_grey_intensities(const PolygonSteps& steps) {
    if (steps.names.size() != 3 || steps.names[0] != "I_r") return false;
    for (const auto& corner : steps.corners) {
        if (!is_grey(corner.values)) return false;
    }
    for (const auto& line : steps.trace.scanlines) {
        if (!all_grey(line.active) || !all_grey(line.spans)) return false;
    }
    return all_grey(steps.trace.edge_table);
}

template <class Items>
void keep_first_value(Items& items) {
    for (auto& item : items) {
        item.values.resize(1);
        item.steps.resize(1);
    }
}

}  // namespace

std::string steps_text(const PolygonSteps& steps, const std::string& title) {
    std::string text = title + "\n\n" + corners_text(steps) + "\n" + edge_table_text(steps);
    for (const auto& line : steps.trace.scanlines) {
        text += "\nScanline " + std::to_string(line.y) + " (centre y = " + fixed(line.y + 0.5, 1) +
                "): active edges from left to right, then what lies between\n" +
                active_text(steps, line) + spans_text(steps, line);
    }
    return text;
}

Json polygon_json(const PolygonSteps& steps) {
    Json corners = Json::array();
    for (const auto& corner : steps.corners)
        corners.push_back(corner_json(steps, corner));
    Json edges = Json::array();
    for (const auto& edge : steps.trace.edge_table)
        edges.push_back(edge_json(steps, edge));
    Json scanlines = Json::array();
    for (const auto& line : steps.trace.scanlines)
        scanlines.push_back(scanline_json(steps, line));
    return {{"polygon", steps.id},
            {"corners", corners},
            {"edge_table", edges},
            {"scanlines", scanlines}};
}

std::string steps_json(const StepsSource& source, const std::vector<PolygonSteps>& polygons) {
    Json list = Json::array();
    for (const auto& steps : polygons)
        list.push_back(polygon_json(steps));
    return json_text({{"header", header_json(source, polygons)}, {"polygons", list}});
}

PolygonSteps with_grey_as_one(PolygonSteps steps) {
    if (!has_grey_intensities(steps)) return steps;
    steps.names = {"I"};
    for (auto& corner : steps.corners)
        corner.values.resize(1);
    keep_first_value(steps.trace.edge_table);
    for (auto& line : steps.trace.scanlines) {
        keep_first_value(line.active);
        keep_first_value(line.spans);
    }
    return steps;
}

}  // namespace scanlight::apps
