#pragma once

#include <memory>

#include "apps/demo/window/gui_input.h"
#include "apps/demo/window/sdl.h"

struct ImFont;
struct ImGuiContext;

namespace scanlight::apps::window {

/// Dear ImGui on an SDL renderer, with the house's letters and colours. One at a time.
class Gui {
public:
    explicit Gui(SDL_Renderer* renderer);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    void take(const SDL_Event& event) { input_->take(event); }
    void begin_frame(int width, int height, float seconds);
    /// Draws what was said since then.
    void draw(SDL_Renderer* renderer);

    /// Whether an event of the mouse, or of the keys, is meant for a control.
    bool wants_mouse() const;
    bool wants_keys() const;

private:
    struct Delete {
        void operator()(ImGuiContext* context) const;
    };
    std::unique_ptr<ImGuiContext, Delete> context_;
    std::unique_ptr<GuiInput> input_;
    Sdl<SDL_Texture> font_;
};

/// Whether there are letters for Chinese; Debian has them in this package.
bool has_chinese_letters();
inline constexpr const char* chinese_package = "fonts-droid-fallback";

/// Letters for captions and plots, while there is a Gui.
ImFont* small_font();

/// The smaller letters, while there is a Gui.
ImFont* subscript_font();

}  // namespace scanlight::apps::window
