#pragma once

#include <optional>

#include "apps/demo/window/events.h"

union SDL_Event;

namespace scanlight::apps::window {

/// Whether it says that the mouse is not over the window any more.
bool leaves_window(const SDL_Event& event);

/// What an event of SDL means for the canvas, whose corner is the window's. None for what means
/// nothing to it. Presses beside it, and what only the controls are told, the caller leaves out.
std::optional<Event> translated(const SDL_Event& event, const WindowState& state);

}  // namespace scanlight::apps::window
