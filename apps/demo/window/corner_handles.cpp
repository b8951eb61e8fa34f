#include "apps/demo/window/corner_handles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "apps/demo/plane_in_picture.h"
#include "apps/demo/settings.h"

namespace scanlight::apps::window {

namespace {

constexpr double handle_radius = 11.0;  // pixels

/// Of what is seen; null where it has no corners, or is of another lesson.
const demo::Control* control_of(const LessonState& state, const demo::Screen& screen) {
    if (!screen.handles) return nullptr;
    const auto& controls = state.lesson().controls;
    const auto found = std::ranges::find(controls, screen.handles->control, &demo::Control::name);
    return found == controls.end() ? nullptr : &*found;
}

demo::Polygon polygon_of(const LessonState& state, const demo::Screen& screen) {
    const demo::Control* control = control_of(state, screen);
    return control == nullptr ? demo::Polygon{} : demo::polygon_of(*control, state.settings);
}

LessonState moved_to(LessonState state, std::size_t corner, const glm::dvec2& place,
                     const demo::Screen& screen) {
    if (corner >= polygon_of(state, screen).size()) return state;
    state.settings =
        demo::with_corner_at(std::move(state.settings), *control_of(state, screen), corner, place);
    return state;
}

}  // namespace

std::vector<Point> corner_places(const LessonState& state, const LessonSight& sight) {
    std::vector<Point> places;
    for (const glm::dvec2& corner : polygon_of(state, sight.screen)) {
        const demo::Handles& handles = *sight.screen.handles;
        const glm::dvec2 at = demo::mapped(handles.picture_from_plane, corner);
        const Box& picture = sight.pictures.at(handles.panel);
        places.push_back({picture.x + at.x, picture.y + at.y});
    }
    return places;
}

std::optional<std::size_t> corner_at(const LessonState& state, Point point,
                                     const LessonSight& sight) {
    const auto places = corner_places(state, sight);
    const auto distance = [&](Point p) { return std::hypot(p.x - point.x, p.y - point.y); };
    const auto nearest = std::ranges::min_element(places, {}, distance);
    if (nearest == places.end() || distance(*nearest) > handle_radius) return std::nullopt;
    return static_cast<std::size_t>(nearest - places.begin());
}

LessonState with_corner_at(LessonState state, std::size_t corner, Point to,
                           const LessonSight& sight) {
    if (!sight.screen.handles) return state;
    const demo::Handles& handles = *sight.screen.handles;
    const Box& picture = sight.pictures.at(handles.panel);
    const glm::dvec2 place = demo::mapped(glm::inverse(handles.picture_from_plane),
                                          {to.x - picture.x, to.y - picture.y});
    return moved_to(std::move(state), corner, place, sight.screen);
}

LessonState with_corner_nudged(LessonState state, int right, int up, const demo::Screen& screen) {
    const demo::Polygon polygon = polygon_of(state, screen);
    if (!state.corner || *state.corner >= polygon.size()) return state;
    const auto& corners = std::get<demo::Corners>(control_of(state, screen)->kind);
    const std::size_t corner = *state.corner;
    const glm::dvec2 place = polygon[corner] + glm::dvec2(right, up) / corners.places_a_unit;
    return moved_to(std::move(state), corner, place, screen);
}

LessonState with_next_corner(LessonState state, const demo::Screen& screen) {
    const std::size_t next = state.corner ? *state.corner + 1 : 0;
    const bool is_there = next < polygon_of(state, screen).size();
    state.corner = is_there ? std::optional(next) : std::nullopt;
    return state;
}

}  // namespace scanlight::apps::window
