#pragma once

#include <array>

union SDL_Event;

namespace scanlight::apps::window {

/// Tells Dear ImGui what SDL's events say, and nothing else: no clock, no mouse that is asked where
/// it is. The same events make the same frames.
class GuiInput {
public:
    /// Call once ImGui has a context.
    GuiInput();

    void take(const SDL_Event& event);

    /// Before each frame, of so many pixels and after so many seconds.
    void begin_frame(int width, int height, float seconds);

private:
    // A click within one frame is seen for the whole of it.
    std::array<bool, 3> is_held_{};
    std::array<bool, 3> was_pressed_{};
};

}  // namespace scanlight::apps::window
