#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "apps/demo/window/lesson_sight.h"
#include "apps/demo/window/lesson_state.h"

namespace scanlight::apps::window {

// The corners of a lesson's polygon as points of the canvas, to be dragged.

/// Where they are; none where the lesson has no such polygon.
std::vector<Point> corner_places(const LessonState& state, const LessonSight& sight);

/// The one that the mouse would take hold of.
std::optional<std::size_t> corner_at(const LessonState& state, Point point,
                                     const LessonSight& sight);

/// A corner moved to the nearest place that it can have.
LessonState with_corner_at(LessonState state, std::size_t corner, Point to,
                           const LessonSight& sight);

/// The corner that was touched last moved by so many of its places. Without one all stays.
LessonState with_corner_nudged(LessonState state, int right, int up, const demo::Screen& screen);

/// The next corner is the one that is touched; after the last none is.
LessonState with_next_corner(LessonState state, const demo::Screen& screen);

}  // namespace scanlight::apps::window
