#include "apps/demo/settings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "apps/scanlight/text_table.h"
#include "apps/scene/parse.h"
#include "apps/scene/usage_error.h"
#include "mesh/corner_text.h"

namespace scanlight::demo {

namespace {

using apps::UsageError;

/// None of corners, which start as a choice has them.
std::optional<double> start_of(const Control& control) {
    if (const auto* slider = std::get_if<Slider>(&control.kind)) return slider->start;
    if (const auto* choice = std::get_if<Choice>(&control.kind))
        return static_cast<double>(choice->start);
    return std::nullopt;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// A slider stands at no more digits than it shows.
void check_digits(const Slider& slider, double value, const std::string& asked) {
    const double unit = std::pow(10.0, slider.digits);
    const auto text = [&](double scaled) { return apps::fixed(scaled / unit, slider.digits); };
    if (std::abs(value * unit - std::round(value * unit)) < 1e-6) return;
    throw UsageError(asked + ": expected " + text(std::floor(value * unit)) + " or " +
                     text(std::ceil(value * unit)) + ", the nearest");
}

double parsed(const Slider& slider, const std::string& name, const std::string& text) {
    const double value = apps::parse_number(text, name);
    const std::string asked = name + " '" + text + "'";
    if (!(value >= slider.low && value <= slider.high))
        throw UsageError(asked + ": expected a number from " +
                         apps::fixed(slider.low, slider.digits) + " to " +
                         apps::fixed(slider.high, slider.digits));
    check_digits(slider, value, asked);
    return value;
}

double parsed(const Choice& choice, const std::string& name, const std::string& text) {
    const auto found = std::ranges::find(choice.words, text);
    if (found == choice.words.end())
        throw UsageError(name + " '" + text + "': expected one of " + joined(choice.words));
    return static_cast<double>(found - choice.words.begin());
}

glm::dvec2 checked(const Corners& corners, const std::string& name, const glm::dvec2& place) {
    const glm::dvec2 nearest = held(corners, place);
    if (glm::distance(nearest, place) < 1e-9) return nearest;
    throw UsageError(name + " '" + mesh::corners_text({&place, 1}) + "': expected " +
                     mesh::corners_text({&nearest, 1}) + ", the nearest place of a corner");
}

Polygon parsed(const Corners& corners, const std::string& name, const std::string& text) {
    Polygon polygon = mesh::parse_corners(text, name);
    for (glm::dvec2& corner : polygon)
        corner = checked(corners, name, corner);
    return polygon;
}

/// Those that start as the choice has them.
void put_back(Settings& settings, const Lesson& lesson, const Control& choice) {
    for (const Control& control : lesson.controls) {
        const auto* corners = std::get_if<Corners>(&control.kind);
        if (corners != nullptr && corners->choice == choice.name)
            settings.corners.erase(control.name);
    }
}

/// Whether the control stands where it starts.
bool is_at_start(const Control& control, const Settings& settings) {
    if (std::holds_alternative<Corners>(control.kind))
        return !settings.corners.contains(control.name);
    return settings.at(control.name) == start_of(control);
}

}  // namespace

Settings starting_settings(const Lesson& lesson) {
    Settings settings;
    for (const Control& control : lesson.controls) {
        if (const auto start = start_of(control)) settings[control.name] = *start;
    }
    return settings;
}

std::vector<double> stops_of(const Control& control) {
    std::vector<double> stops;
    if (const auto* slider = std::get_if<Slider>(&control.kind)) {
        const double step = (slider->high - slider->low) / std::max(1, slider->stops - 1);
        for (int i = 0; i < slider->stops; ++i)
            stops.push_back(held(control, slider->low + step * i));
        return stops;
    }
    const auto* choice = std::get_if<Choice>(&control.kind);
    for (std::size_t i = 0; choice != nullptr && i < choice->words.size(); ++i)
        stops.push_back(static_cast<double>(i));
    return stops;
}

std::string value_text(const Control& control, double value) {
    if (const auto* slider = std::get_if<Slider>(&control.kind))
        return apps::fixed(value, slider->digits);
    return std::get<Choice>(control.kind).words[static_cast<std::size_t>(value)];
}

std::string text_of(const Control& control, const Settings& settings) {
    if (std::holds_alternative<Corners>(control.kind))
        return mesh::corners_text(polygon_of(control, settings));
    return value_text(control, settings.at(control.name));
}

std::vector<std::string> assignments_of(const Lesson& lesson, const Settings& settings) {
    std::vector<std::string> assignments;
    for (const Control& control : lesson.controls) {
        if (!is_at_start(control, settings))
            assignments.push_back(control.name + "=" + text_of(control, settings));
    }
    return assignments;
}

double held(const Control& control, double value) {
    if (const auto* slider = std::get_if<Slider>(&control.kind)) {
        const double power = std::pow(10.0, slider->digits);
        return std::clamp(std::round(value * power) / power, slider->low, slider->high);
    }
    const auto last = static_cast<double>(std::get<Choice>(control.kind).words.size()) - 1.0;
    return std::clamp(std::round(value), 0.0, last);
}

glm::dvec2 held(const Corners& corners, const glm::dvec2& place) {
    const glm::dvec2 inside = glm::clamp(place, corners.low, corners.high);
    return glm::round(inside * corners.places_a_unit) / corners.places_a_unit + 0.0;  // never -0
}

Settings with_value(Settings settings, const Lesson& lesson, const Control& control, double value) {
    settings[control.name] = held(control, value);
    put_back(settings, lesson, control);
    return settings;
}

const Polygon& polygon_of(const Control& control, const Settings& settings) {
    const auto moved = settings.corners.find(control.name);
    if (moved != settings.corners.end()) return moved->second;
    const auto& corners = std::get<Corners>(control.kind);
    return corners.starts.at(static_cast<std::size_t>(settings.at(corners.choice)));
}

Settings with_corner_at(Settings settings, const Control& control, std::size_t corner,
                        const glm::dvec2& place) {
    Polygon polygon = polygon_of(control, settings);
    const glm::dvec2 nearest = held(std::get<Corners>(control.kind), place);
    if (polygon.at(corner) == nearest) return settings;
    polygon[corner] = nearest;
    settings.corners[control.name] = std::move(polygon);
    return settings;
}

void set(Settings& settings, const Lesson& lesson, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
        throw UsageError("'" + assignment + "': expected CONTROL=VALUE");
    const Control& control = control_named(lesson, assignment.substr(0, equals));
    const std::string text = assignment.substr(equals + 1);
    if (const auto* corners = std::get_if<Corners>(&control.kind)) {
        settings.corners[control.name] = parsed(*corners, control.name, text);
    } else if (const auto* slider = std::get_if<Slider>(&control.kind)) {
        settings[control.name] = parsed(*slider, control.name, text);
    } else {
        settings[control.name] = parsed(std::get<Choice>(control.kind), control.name, text);
        put_back(settings, lesson, control);
    }
}

void set_frame(Settings& settings, const Lesson& lesson, int frame) {
    const Control& control = lesson.controls.front();
    const auto stops = stops_of(control);
    if (frame < 0 || static_cast<std::size_t>(frame) >= stops.size()) {
        throw UsageError("frame " + std::to_string(frame) + ": " + lesson.name +
                         " has frames from 0 to " + std::to_string(stops.size() - 1));
    }
    settings[control.name] = stops[static_cast<std::size_t>(frame)];
}

const Control& control_named(const Lesson& lesson, const std::string& name) {
    const auto found = std::ranges::find(lesson.controls, name, &Control::name);
    if (found != lesson.controls.end()) return *found;
    std::vector<std::string> names;
    for (const Control& control : lesson.controls)
        names.push_back(control.name);
    throw UsageError(lesson.name + " has no control '" + name + "', but " + joined(names));
}

const std::string& word_of(const std::vector<std::string>& words, const Settings& settings,
                           const std::string& choice) {
    return words.at(static_cast<std::size_t>(settings.at(choice)));
}

}  // namespace scanlight::demo
