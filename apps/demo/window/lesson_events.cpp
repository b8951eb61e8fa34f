#include "apps/demo/window/lesson_events.h"

#include <algorithm>
#include <utility>

#include "apps/demo/window/corner_handles.h"

namespace scanlight::apps::window {

namespace {

std::optional<std::size_t> picture_at(Point point, const LessonSight& sight) {
    for (std::size_t i = 0; i < sight.pictures.size(); ++i) {
        if (sight.pictures[i].holds(point)) return i;
    }
    return std::nullopt;
}

bool takes_points(const demo::Lesson& lesson) {
    const auto is_pointed = [](const demo::Control& control) {
        return control.pointed != demo::Pointed::nowhere;
    };
    return std::ranges::any_of(lesson.controls, is_pointed);
}

/// Of the pixel's centre.
double share_of(double at, int begin, int length) {
    return std::clamp((at - begin + 0.5) / length, 0.0, 1.0);
}

LessonState pointed(LessonState state, Point at, const Box& picture) {
    for (const demo::Control& control : state.lesson().controls) {
        if (control.pointed == demo::Pointed::column)
            state =
                with_control(std::move(state), control, share_of(at.x, picture.x, picture.width));
        if (control.pointed == demo::Pointed::row)
            state =
                with_control(std::move(state), control, share_of(at.y, picture.y, picture.height));
    }
    return state;
}

// ---- what is dragged

LessonDrag drag_from(const LessonState& state, const Press& press, const LessonSight& sight) {
    if (press.button != Button::left) return {};
    if (const auto corner = corner_at(state, press.at, sight)) {
        const Point place = corner_places(state, sight)[*corner];
        return MovingCorner{*corner, {place.x - press.at.x, place.y - press.at.y}};
    }
    const auto panel = picture_at(press.at, sight);
    if (panel && takes_points(state.lesson())) return Pointing{*panel};
    return {};
}

std::optional<std::size_t> corner_of(const LessonDrag& drag) {
    const auto* moving = std::get_if<MovingCorner>(&drag);
    return moving != nullptr ? std::optional(moving->corner) : std::nullopt;
}

LessonState dragged(LessonState state, std::monostate, Point, const LessonSight&) {
    return state;
}

LessonState dragged(LessonState state, const Pointing& drag, Point to, const LessonSight& sight) {
    if (drag.panel >= sight.pictures.size()) return state;
    return pointed(std::move(state), to, sight.pictures[drag.panel]);
}

LessonState dragged(LessonState state, const MovingCorner& drag, Point to,
                    const LessonSight& sight) {
    return with_corner_at(std::move(state), drag.corner, {to.x + drag.grip.x, to.y + drag.grip.y},
                          sight);
}

WindowState dragged(WindowState state, Point to, const LessonSight& sight) {
    const LessonDrag drag = state.lesson.drag;
    state.lesson = std::visit(
        [&](const auto& what) { return dragged(std::move(state.lesson), what, to, sight); }, drag);
    return state;
}

// ---- events

struct After {
    WindowState state;
    const LessonSight& sight;

    WindowState operator()(const Press& press) {
        state.lesson.drag = drag_from(state.lesson, press, sight);
        state.lesson.corner = corner_of(state.lesson.drag);
        return dragged(std::move(state), press.at, sight);
    }
    WindowState operator()(const Move& move) {
        state.mouse = move.to;
        return dragged(std::move(state), move.to, sight);
    }
    WindowState operator()(Release) {
        state.lesson.drag = {};
        return std::move(state);
    }
    WindowState operator()(Leave) {
        state.mouse.reset();
        return std::move(state);
    }
    WindowState operator()(const Wheel&) { return std::move(state); }
    WindowState operator()(const Key& key) {
        if (key.letter == 'a') state.lesson = with_answer_turned(std::move(state.lesson));
        if (key.letter == '\t')
            state.lesson = with_next_corner(std::move(state.lesson), sight.screen);
        return std::move(state);
    }
    WindowState operator()(const Nudge& nudge) {
        state.lesson =
            with_corner_nudged(std::move(state.lesson), nudge.right, nudge.up, sight.screen);
        return std::move(state);
    }
    WindowState operator()(NamedKey key) {
        if (key == NamedKey::escape) return about(std::move(state), Subject::scene);
        state.lesson = after_key(std::move(state.lesson), key);
        return std::move(state);
    }

    LessonState after_key(LessonState lesson, NamedKey key) {
        switch (key) {
            case NamedKey::left:
                return moved(std::move(lesson), Way::back, sight.screen);
            case NamedKey::right:
                return moved(std::move(lesson), Way::forward, sight.screen);
            case NamedKey::up:
                return moved(std::move(lesson), Way::scanline_back, sight.screen);
            case NamedKey::down:
                return moved(std::move(lesson), Way::scanline_forward, sight.screen);
            case NamedKey::home:
                return moved(std::move(lesson), Way::first, sight.screen);
            case NamedKey::end:
                return moved(std::move(lesson), Way::last, sight.screen);
            case NamedKey::page_up:
                return with_previous(std::move(lesson));
            case NamedKey::page_down:
                return with_next(std::move(lesson));
            case NamedKey::escape:
                break;
        }
        return lesson;
    }
};

}  // namespace

WindowState after_in_lesson(WindowState state, const Event& event, const LessonSight& sight) {
    return std::visit(After{std::move(state), sight}, event);
}

bool can_point_at(const LessonState& lesson, Point point, const LessonSight& sight) {
    return corner_at(lesson, point, sight) ||
           (takes_points(lesson.lesson()) && picture_at(point, sight));
}

}  // namespace scanlight::apps::window
