#pragma once

#include "apps/demo/window/events.h"
#include "apps/demo/window/lesson_sight.h"
#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

/// What an event makes of the state while a lesson is shown. A corner of its polygon is dragged, or
/// moved by keys; any other place in a picture, pressed or dragged over, sets the controls that can
/// be pointed at.
WindowState after_in_lesson(WindowState state, const Event& event, const LessonSight& sight);

/// Whether the mouse would set a control there, or take hold of a corner.
bool can_point_at(const LessonState& lesson, Point point, const LessonSight& sight);

}  // namespace scanlight::apps::window
