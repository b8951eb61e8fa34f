#pragma once

#include <array>
#include <variant>

#include "apps/demo/window/state.h"
#include "render/camera.h"

namespace scanlight::apps::window {

// What a person does with the picture. The window translates its events into these; tests make
// them.

enum class Button { left, middle, right };

struct Press {
    Point at;
    Button button = Button::left;
    bool is_shifted = false;  // with the shift key
};
struct Move {
    Point to;
};
struct Release {};
struct Leave {};  // the mouse is not over the canvas any more
struct Wheel {
    double notches = 0.0;  // away from the person: larger
};
struct Key {
    char letter = ' ';  // lower case, or '\t'
};
struct Nudge {  // the shift key with an arrow
    int right = 0;
    int up = 0;
};
enum class NamedKey { left, right, up, down, home, end, page_up, page_down, escape };
using Event = std::variant<Press, Move, Release, Leave, Wheel, Key, Nudge, NamedKey>;

/// The cameras by which the two views were drawn.
using Cameras = std::array<render::Camera, 2>;

/// What an event makes of the state while a scene is shown. A left drag takes a light's handle or
/// the divider, or else turns the camera; with shift, or by another button, it pans. Cameras of
/// both views move alike.
WindowState after(WindowState state, const Event& event, const Cameras& cameras);

/// What the mouse would take hold of.
enum class Target { nothing, picture, divider, light };
Target target_at(const WindowState& state, Point point, const Cameras& cameras);

}  // namespace scanlight::apps::window
