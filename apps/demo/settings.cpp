#include "apps/demo/settings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "apps/scanlight/text_table.h"
#include "apps/scene/parse.h"
#include "apps/scene/usage_error.h"

namespace scanlight::demo {

namespace {

using apps::UsageError;

double start_of(const Control& control) {
    if (const auto* slider = std::get_if<Slider>(&control.kind)) return slider->start;
    return static_cast<double>(std::get<Choice>(control.kind).start);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

const Control& control_named(const Lesson& lesson, const std::string& name) {
    const auto found = std::ranges::find(lesson.controls, name, &Control::name);
    if (found != lesson.controls.end()) return *found;
    std::vector<std::string> names;
    for (const Control& control : lesson.controls)
        names.push_back(control.name);
    throw UsageError(lesson.name + " has no control '" + name + "', but " + joined(names));
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

}  // namespace

Settings starting_settings(const Lesson& lesson) {
    Settings settings;
    for (const Control& control : lesson.controls)
        settings[control.name] = start_of(control);
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
    for (std::size_t i = 0; i < std::get<Choice>(control.kind).words.size(); ++i)
        stops.push_back(static_cast<double>(i));
    return stops;
}

std::string value_text(const Control& control, double value) {
    if (const auto* slider = std::get_if<Slider>(&control.kind))
        return apps::fixed(value, slider->digits);
    return std::get<Choice>(control.kind).words[static_cast<std::size_t>(value)];
}

double held(const Control& control, double value) {
    if (const auto* slider = std::get_if<Slider>(&control.kind)) {
        const double power = std::pow(10.0, slider->digits);
        return std::clamp(std::round(value * power) / power, slider->low, slider->high);
    }
    const auto last = static_cast<double>(std::get<Choice>(control.kind).words.size()) - 1.0;
    return std::clamp(std::round(value), 0.0, last);
}

void set(Settings& settings, const Lesson& lesson, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
        throw UsageError("'" + assignment + "': expected CONTROL=VALUE");
    const Control& control = control_named(lesson, assignment.substr(0, equals));
    const std::string text = assignment.substr(equals + 1);
    settings[control.name] = std::visit(
        [&](const auto& kind) { return parsed(kind, control.name, text); }, control.kind);
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

const std::string& word_of(const Lesson& lesson, const Settings& settings,
                           const std::string& control) {
    const auto& choice = std::get<Choice>(control_named(lesson, control).kind);
    return choice.words[static_cast<std::size_t>(settings.at(control))];
}

}  // namespace scanlight::demo
