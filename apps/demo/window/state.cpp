#include "apps/demo/window/state.h"

#include <algorithm>
#include <cmath>

#include "apps/scene/read_scene.h"

namespace scanlight::apps::window {

namespace {

/// Neither view is less than this.
constexpr int least_width = 16;

WindowState with_sizes(WindowState state) {
    for (const View view : {View::left, View::right})
        state.of(view).size = state.canvas;
    if (state.arrangement != Arrangement::beside) return state;
    const int column = divider_column(state);
    state.of(View::left).size.width = column;
    state.of(View::right).size.width = state.canvas.width - column;
    return state;
}

/// A scene file brings all settings, anything else is seen by those there are.
SceneOptions showing(SceneOptions view, const std::string& input) {
    if (names_scene(input)) {
        view = {};
    } else {
        view.objects.clear();
        view.zoom = 1.0;
        look_from(view, view.view);
    }
    set_input(view, input);
    return view;
}

}  // namespace

bool has_divider(const WindowState& state) {
    return state.arrangement == Arrangement::wipe || state.arrangement == Arrangement::beside;
}

int divider_column(const WindowState& state) {
    const int column = static_cast<int>(std::lround(state.divider * state.canvas.width));
    return std::clamp(column, least_width, std::max(least_width, state.canvas.width - least_width));
}

std::vector<Pane> panes_of(const WindowState& state) {
    const auto [width, height] = state.canvas;
    const Box all{0, 0, width, height};
    if (!has_divider(state)) return {{state.chosen, all, all}};
    const int column = divider_column(state);
    const Box left{0, 0, column, height};
    const Box right{column, 0, width - column, height};
    if (state.arrangement == Arrangement::beside)
        return {{View::left, left, left}, {View::right, right, right}};
    return {{View::left, all, left}, {View::right, all, right}};
}

std::optional<Pane> pane_at(const WindowState& state, Point point) {
    for (const Pane& pane : panes_of(state)) {
        if (pane.visible.holds(point)) return pane;
    }
    return std::nullopt;
}

WindowState window_of(const SceneOptions& scene) {
    WindowState state;
    state.views = {scene, scene};
    state.canvas = scene.size;
    return with_sizes(std::move(state));
}

WindowState arranged(WindowState state, Arrangement arrangement) {
    state.arrangement = arrangement;
    return with_sizes(std::move(state));
}

WindowState on_canvas(WindowState state, raster::Viewport canvas) {
    state.canvas = canvas;
    return with_sizes(std::move(state));
}

WindowState about(WindowState state, Subject subject) {
    state.subject = subject;
    state.drag = {};
    state.lesson.drag = {};
    return state;
}

bool is_dragging(const WindowState& state) {
    return !std::holds_alternative<std::monostate>(state.drag) ||
           !std::holds_alternative<std::monostate>(state.lesson.drag);
}

WindowState with_input(WindowState state, const std::string& input) {
    for (SceneOptions& view : state.views)
        view = showing(std::move(view), input);
    state.picked.reset();
    // Seen, so that it is drawn, or refused, at once.
    return about(with_sizes(std::move(state)), Subject::scene);
}

WindowState framed(WindowState state, const render::ViewAngles& view) {
    for (SceneOptions& options : state.views) {
        look_from(options, view);
        options.zoom = 1.0;
    }
    return state;
}

WindowState with_lesson(WindowState state, LessonState lesson) {
    state.lesson = std::move(lesson);
    return about(std::move(state), Subject::lesson);
}

WindowState with_other_alike(WindowState state) {
    state.of(other(state.chosen)) = state.current();
    return with_sizes(std::move(state));
}

}  // namespace scanlight::apps::window
