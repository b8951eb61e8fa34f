#pragma once

#include <array>
#include <optional>
#include <string>

#include "apps/demo/window/events.h"
#include "apps/demo/window/painter.h"
#include "apps/demo/window/sdl.h"
#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

/// A picture on its way to the screen.
class Sheet {
public:
    bool shows(const std::string& name) const { return name == name_ && texture_ != nullptr; }
    /// Takes over the pixels, if they are not those that it has already; `name` tells.
    void show(const Pixels& pixels, const std::string& name, SDL_Renderer* renderer);
    /// Draws what is visible of it.
    void draw(const Pane& pane, SDL_Renderer* renderer) const;

private:
    Sdl<SDL_Texture> texture_;
    int width_ = 0;
    int height_ = 0;
    std::string name_;
};

/// Over the pictures, with ImGui's background list: the divider, what each side is, the lights'
/// handles.
void draw_marks(const WindowState& state, const Cameras& cameras);

/// "gouraud, blinn, shadows zfail": what a view is drawn by.
std::string name_of(const SceneOptions& options);

/// Whether the panel is about it.
enum class Look { plain, chosen };

/// A line of text on a dark ground, its upper left corner there.
void draw_label(const std::string& text, Point at, Look look = Look::plain);

}  // namespace scanlight::apps::window
