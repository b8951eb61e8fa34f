#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "apps/demo/lesson.h"
#include "apps/demo/texts.h"
#include "apps/demo/walk.h"
#include "apps/demo/window/box.h"

namespace scanlight::apps::window {

/// Whether a lesson's question is answered.
enum class Answer { hidden, shown };

// What the mouse has hold of in a lesson's pictures.

struct Pointing {
    std::size_t panel = 0;  // whose places set controls
};
struct MovingCorner {
    std::size_t corner = 0;
    Point grip;  // from the mouse to the corner
};
using LessonDrag = std::variant<std::monostate, Pointing, MovingCorner>;

/// A lesson as it stands in the window.
struct LessonState {
    std::size_t place = 0;  // in the course
    demo::Settings settings;
    demo::Language language = demo::Language::english;
    Answer answer = Answer::hidden;
    LessonDrag drag;
    std::optional<std::size_t> corner;  // touched last, which keys move

    const demo::Lesson& lesson() const { return demo::lessons()[place]; }
};

/// A lesson as it starts.
LessonState opened(std::size_t place, demo::Language language);

/// By its name. Throws UsageError for one that there is not.
LessonState opened(const std::string& name, demo::Language language);

/// The lesson before or after; at the ends of the course the same.
LessonState with_previous(LessonState state);
LessonState with_next(LessonState state);

LessonState with_answer_turned(LessonState state);

/// A control set to the nearest value that it can have.
LessonState with_control(LessonState state, const demo::Control& control, double value);

/// Corners where they start.
LessonState with_corners_back(LessonState state, const demo::Control& control);

/// Where the lesson's first control goes: to a stop of it, or in a walk to a step or a scanline.
enum class Way { first, scanline_back, back, forward, scanline_forward, last };

/// `shown` is what the lesson shows as it stands.
LessonState moved(LessonState state, Way way, const demo::Screen& shown);

/// The step of a walk that is shown; none if the lesson has no walk.
std::optional<demo::WalkStep> step_shown(const LessonState& state, const demo::Screen& shown);

/// The last value of the first control: of a walk the last step that there is.
double last_value(const demo::Control& control, const demo::Screen& shown);

/// With no step of a walk beyond the last that is shown.
LessonState as_shown(LessonState state, const demo::Screen& shown);

/// "scanlight-demo --lesson mach-bands --set cut=0.400": this very screen, without a window.
std::string command_of(const LessonState& state);

/// And its pictures, each panel of this size.
std::string command_of(const LessonState& state, raster::Viewport panel);

}  // namespace scanlight::apps::window
