#include "apps/demo/page.h"

#include <cstddef>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/demo/base64.h"
#include "apps/demo/code_at_work.h"
#include "apps/demo/embedded.h"
#include "apps/demo/lesson.h"
#include "apps/demo/plot_svg.h"
#include "apps/demo/settings.h"
#include "apps/demo/walk.h"
#include "apps/scanlight/steps_report.h"
#include "apps/scanlight/text_table.h"
#include "apps/scene/json.h"
#include "raster/encode_png.h"

namespace scanlight::demo {

namespace {

using apps::Json;

/// The pictures of a page, each once however often it is shown.
class Pictures {
public:
    /// Its place among them.
    std::size_t add(const raster::Image8& picture) {
        const std::string url = "data:image/png;base64," + base64(raster::encode_png(picture));
        const auto [found, is_new] = places_.emplace(url, places_.size());
        if (is_new) urls_.push_back(url);
        return found->second;
    }

    const std::vector<std::string>& urls() const { return urls_; }

private:
    std::map<std::string, std::size_t> places_;
    std::vector<std::string> urls_;
};

Json point_json(const glm::dvec2& p) {
    return Json::parse("[" + apps::fixed(p.x, 1) + "," + apps::fixed(p.y, 1) + "]");
}

Json panel_json(const Panel& panel, Pictures& pictures) {
    Json marks = Json::array();
    for (const Mark& mark : panel.marks)
        marks.push_back({point_json(mark.from), point_json(mark.to)});
    return {{"key", panel.key},
            {"picture", pictures.add(panel.picture)},
            {"width", panel.picture.width()},
            {"height", panel.picture.height()},
            {"command", panel.command},
            {"marks", marks}};
}

Json numbers_json(const Screen& screen) {
    Json numbers = Json::array();
    for (const Number& number : screen.numbers)
        numbers.push_back({{"key", number.key},
                           {"value", apps::fixed(number.value, number.digits)},
                           {"unit", number.unit}});
    return numbers;
}

Json plots_json(const Screen& screen) {
    Json plots = Json::array();
    for (const Plot& plot : screen.plots)
        plots.push_back({{"key", plot.key}, {"svg", plot_svg(plot)}});
    return plots;
}

Json tables_json(const Screen& screen) {
    Json tables = Json::array();
    for (const Table& table : screen.tables)
        tables.push_back({{"key", table.key}, {"columns", table.columns}, {"rows", table.rows}});
    return tables;
}

std::string kind_word(WalkStep::Kind kind) {
    switch (kind) {
        case WalkStep::Kind::edge:
            return "edge";
        case WalkStep::Kind::scanline:
            return "scanline";
        case WalkStep::Kind::pixel:
            break;
    }
    return "pixel";
}

/// By the kind of step.
Json code_json() {
    Json code = Json::object();
    using Kind = WalkStep::Kind;
    for (const Kind kind : {Kind::edge, Kind::scanline, Kind::pixel}) {
        const Excerpt excerpt = code_at_work(kind);
        code[kind_word(kind)] = {
            {"file", excerpt.file}, {"lines", excerpt.lines}, {"at_work", excerpt.at_work}};
    }
    return code;
}

/// The recorded trace, and the order in which a person steps through it.
Json walked_json(const Walked& walked, Pictures& pictures) {
    const render::PolygonSteps& steps = walked.steps;
    Json walk = Json::array();
    for (const WalkStep& step : walk_of(steps.trace))
        walk.push_back({kind_word(step.kind), step.edge, step.line, step.span, step.x});
    return {{"polygon", apps::polygon_json(steps)},
            {"names", steps.names},
            {"walk", walk},
            {"picture", pictures.add(walked.picture)}};
}

Json screen_json(const Screen& screen, Pictures& pictures) {
    Json panels = Json::array();
    for (const Panel& panel : screen.panels)
        panels.push_back(panel_json(panel, pictures));
    Json json{{"panels", panels}, {"numbers", numbers_json(screen)}, {"plots", plots_json(screen)}};
    if (screen.walked) {
        json["steps"] = walked_json(*screen.walked, pictures);
    } else {
        json["tables"] = tables_json(screen);
    }
    return json;
}

Json control_json(const Control& control, double start) {
    const auto stops = stops_of(control);
    Json words = Json::array();
    std::size_t at = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        words.push_back(value_text(control, stops[i]));
        if (words.back() == value_text(control, start)) at = i;
    }
    return {{"name", control.name},
            {"symbol", control.symbol},
            {"is_choice", std::holds_alternative<Choice>(control.kind)},
            {"stops", words},
            {"start", at}};
}

/// The controls that move among pictures drawn beforehand.
std::vector<Control> drawn_controls(const Lesson& lesson) {
    std::vector<Control> controls;
    for (const Control& control : lesson.controls) {
        if (control.moved == Moved::by_pictures) controls.push_back(control);
    }
    return controls;
}

/// The names of those that the window alone can move.
Json pointed_names(const Lesson& lesson) {
    Json names = Json::array();
    for (const Control& control : lesson.controls) {
        if (control.moved == Moved::by_pointing) names.push_back(control.name);
    }
    return names;
}

/// One screen for each way the controls may stand; the last control changes fastest.
std::vector<Settings> all_settings(const Lesson& lesson) {
    std::vector<Settings> all{starting_settings(lesson)};
    for (const Control& control : drawn_controls(lesson)) {
        std::vector<Settings> more;
        for (const Settings& settings : all) {
            for (const double stop : stops_of(control)) {
                more.push_back(settings);
                more.back()[control.name] = stop;
            }
        }
        all = std::move(more);
    }
    return all;
}

Json lesson_json(const Lesson& lesson, const PageOptions& options, Pictures& pictures) {
    Json controls = Json::array();
    const Settings start = starting_settings(lesson);
    for (const Control& control : drawn_controls(lesson))
        controls.push_back(control_json(control, start.at(control.name)));
    Json places = Json::array();
    for (const SourcePlace& place : lesson.places)
        places.push_back({{"file", place.file}, {"function", place.function}});
    Json files = Json::array();
    for (const BroughtFile& file : lesson.files)
        files.push_back({{"path", file.path}, {"content", file.content}});
    Json screens = Json::array();
    for (const Settings& settings : all_settings(lesson))
        screens.push_back(
            screen_json(lesson.draw(settings, options.panel_size, options.means), pictures));
    return {{"name", lesson.name},  {"formula", texts().chapters().at(lesson.name).formula},
            {"controls", controls}, {"pointed", pointed_names(lesson)},
            {"places", places},     {"files", files},
            {"screens", screens}};
}

Json texts_json() {
    Json all = Json::object();
    for (const auto& [name, chapter] : texts().chapters())
        all[name] = {{"en", chapter.english}, {"zh", chapter.chinese}};
    return all;
}

/// As a script element may hold it: no tag can begin in it.
std::string in_script(const Json& json) {
    std::string result;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
        result += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return result;
}

/// A template with each {{name}} replaced.
std::string filled(std::string_view text, const std::map<std::string, std::string>& parts) {
    std::string result;
    while (!text.empty()) {
        const std::size_t begin = text.find("{{");
        const std::size_t end = begin == text.npos ? text.npos : text.find("}}", begin);
        result += text.substr(0, end == text.npos ? text.npos : begin);
        if (end == text.npos) break;
        result += parts.at(std::string(text.substr(begin + 2, end - begin - 2)));
        text.remove_prefix(end + 2);
    }
    return result;
}

}  // namespace

std::string course_page(const std::vector<Lesson>& lessons, const PageOptions& options,
                        const std::function<void(const std::string&)>& now) {
    Pictures pictures;
    Json all = Json::array();
    for (const Lesson& lesson : lessons) {
        now(lesson.name);
        all.push_back(lesson_json(lesson, options, pictures));
    }
    const std::string language = options.language == Language::english ? "en" : "zh";
    const Json data{{"lessons", all},
                    {"texts", texts_json()},
                    {"code", code_json()},
                    {"pictures", pictures.urls()}};
    return filled(embedded::index, {{"language", language},
                                    {"style", std::string(embedded::style)},
                                    {"data", in_script(data)},
                                    {"steps-script", std::string(embedded::steps_script)},
                                    {"page-script", std::string(embedded::page_script)}});
}

}  // namespace scanlight::demo
