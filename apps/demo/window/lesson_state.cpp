#include "apps/demo/window/lesson_state.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "apps/demo/settings.h"

namespace scanlight::apps::window {

namespace {

constexpr double nearly = 1e-9;

// ---- among stops

double stop_after(const std::vector<double>& stops, double value) {
    const auto is_after = [&](double stop) { return stop > value + nearly; };
    const auto found = std::ranges::find_if(stops, is_after);
    return found == stops.end() ? stops.back() : *found;
}

double stop_before(const std::vector<double>& stops, double value) {
    double best = stops.front();
    for (const double stop : stops) {
        if (stop < value - nearly) best = stop;
    }
    return best;
}

double moved_stop(const std::vector<double>& stops, double value, Way way) {
    switch (way) {
        case Way::first:
            return stops.front();
        case Way::back:
            return stop_before(stops, value);
        case Way::forward:
            return stop_after(stops, value);
        case Way::last:
            return stops.back();
        case Way::scanline_back:
        case Way::scanline_forward:
            break;
    }
    return value;
}

// ---- in a walk

bool enters_scanline(const demo::WalkStep& step) {
    return step.kind == demo::WalkStep::Kind::scanline;
}

std::size_t scanline_before(const std::vector<demo::WalkStep>& walk, std::size_t step) {
    while (step > 0) {
        if (enters_scanline(walk[--step])) break;
    }
    return step;
}

std::size_t scanline_after(const std::vector<demo::WalkStep>& walk, std::size_t step) {
    while (step + 1 < walk.size()) {
        if (enters_scanline(walk[++step])) break;
    }
    return step;
}

std::size_t moved_step(const std::vector<demo::WalkStep>& walk, std::size_t step, Way way) {
    const std::size_t last = walk.size() - 1;
    switch (way) {
        case Way::first:
            return 0;
        case Way::scanline_back:
            return scanline_before(walk, step);
        case Way::back:
            return step == 0 ? 0 : step - 1;
        case Way::forward:
            return std::min(step + 1, last);
        case Way::scanline_forward:
            return scanline_after(walk, step);
        case Way::last:
            break;
    }
    return last;
}

double moved_in_walk(const demo::Screen& shown, double value, Way way) {
    const auto walk = demo::walk_of(shown.walked->steps.trace);
    const auto step = std::min(static_cast<std::size_t>(value), walk.size() - 1);
    return static_cast<double>(moved_step(walk, step, way));
}

bool goes_by_steps(const demo::Control& control, const demo::Screen& shown) {
    return control.moved == demo::Moved::by_steps && shown.walked;
}

}  // namespace

LessonState opened(std::size_t place, demo::Language language) {
    LessonState state;
    state.place = place;
    state.settings = demo::starting_settings(state.lesson());
    state.language = language;
    return state;
}

LessonState opened(const std::string& name, demo::Language language) {
    const demo::Lesson& lesson = demo::lesson_named(name);
    return opened(static_cast<std::size_t>(&lesson - demo::lessons().data()), language);
}

LessonState with_previous(LessonState state) {
    return state.place == 0 ? state : opened(state.place - 1, state.language);
}

LessonState with_next(LessonState state) {
    const bool is_last = state.place + 1 == demo::lessons().size();
    return is_last ? state : opened(state.place + 1, state.language);
}

LessonState with_answer_turned(LessonState state) {
    state.answer = state.answer == Answer::shown ? Answer::hidden : Answer::shown;
    return state;
}

LessonState with_control(LessonState state, const demo::Control& control, double value) {
    state.settings =
        demo::with_value(std::move(state.settings), demo::lessons()[state.place], control, value);
    return state;
}

LessonState with_corners_back(LessonState state, const demo::Control& control) {
    state.settings.corners.erase(control.name);
    return state;
}

LessonState moved(LessonState state, Way way, const demo::Screen& shown) {
    const demo::Control& control = state.lesson().controls.front();
    const double value = state.settings.at(control.name);
    const double next = goes_by_steps(control, shown)
                            ? moved_in_walk(shown, value, way)
                            : moved_stop(demo::stops_of(control), value, way);
    return with_control(std::move(state), control, next);
}

std::optional<demo::WalkStep> step_shown(const LessonState& state, const demo::Screen& shown) {
    const demo::Control& control = state.lesson().controls.front();
    if (!goes_by_steps(control, shown)) return std::nullopt;
    const auto walk = demo::walk_of(shown.walked->steps.trace);
    return walk.at(
        std::min(static_cast<std::size_t>(state.settings.at(control.name)), walk.size() - 1));
}

double last_value(const demo::Control& control, const demo::Screen& shown) {
    if (goes_by_steps(control, shown))
        return static_cast<double>(demo::walk_of(shown.walked->steps.trace).size() - 1);
    return demo::stops_of(control).back();
}

LessonState as_shown(LessonState state, const demo::Screen& shown) {
    const demo::Control& control = state.lesson().controls.front();
    if (!goes_by_steps(control, shown)) return state;
    double& step = state.settings[control.name];
    step = std::min(step, last_value(control, shown));
    return state;
}

std::string command_of(const LessonState& state) {
    std::string command = "scanlight-demo --lesson " + state.lesson().name;
    for (const std::string& assignment : demo::assignments_of(state.lesson(), state.settings))
        command += " --set " + assignment;
    return command;
}

std::string command_of(const LessonState& state, raster::Viewport panel) {
    return command_of(state) + " -s " + std::to_string(panel.width) + "x" +
           std::to_string(panel.height) + " -o picture.png";
}

}  // namespace scanlight::apps::window
