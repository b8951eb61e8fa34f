#pragma once

#include "apps/demo/window/events.h"
#include "apps/demo/window/lesson_layout.h"
#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

/// What a person sees of a lesson, and so means.
struct LessonSight {
    const demo::Screen& screen;
    std::vector<Box> pictures;  // of the panels, as large as they are
    raster::Viewport panel;     // the size that the lesson was asked for
};

/// What an event makes of the state while a lesson is shown. A place in a picture, pressed or
/// dragged over, sets the controls that can be pointed at.
WindowState after_in_lesson(WindowState state, const Event& event, const LessonSight& sight);

/// Whether the mouse would set a control there.
bool can_point_at(const LessonState& lesson, Point point, const LessonSight& sight);

}  // namespace scanlight::apps::window
