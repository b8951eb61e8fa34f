#pragma once

#include <map>
#include <string>

#include "apps/demo/window/lesson_events.h"
#include "apps/demo/window/panel.h"

namespace scanlight::apps::window {

/// What stands beside a lesson's pictures: its controls, its numbers and its words.
class LessonPanel {
public:
    struct Result {
        WindowState state;
        std::string to_copy;  // a command that is asked for; else empty
        Wish wish = Wish::nothing;
    };
    /// Between two calls of Gui: draws it into columns [x, x + Panel::width) of the window.
    /// `message` is what was done last, or went wrong.
    Result draw(WindowState state, const LessonSight& sight, const std::string& message, int x,
                int height);

    /// Where each control of the last frame stood in the window, by its name; corners in the
    /// picture as "corner 0" and so on.
    const std::map<std::string, Box>& places() const { return places_; }

private:
    Wish draw_ways(WindowState& state);
    void draw_controls(LessonState& lesson, const LessonSight& sight);
    void draw_corners(LessonState& lesson, const demo::Control& control);
    void note_corners(const LessonState& lesson, const LessonSight& sight);
    void draw_steps(LessonState& lesson, const demo::Screen& screen);
    void draw_question(LessonState& lesson);
    std::string draw_commands(const LessonState& lesson, const LessonSight& sight);
    bool draw_button(const std::string& name, const std::string& label);

    std::map<std::string, Box> places_;
};

}  // namespace scanlight::apps::window
