#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "apps/demo/window/canvas.h"
#include "apps/demo/window/gui.h"
#include "apps/demo/window/lesson_panel.h"
#include "apps/demo/window/lesson_view.h"
#include "apps/demo/window/loupe.h"
#include "apps/demo/window/painter.h"
#include "apps/demo/window/panel.h"
#include "apps/demo/window/sdl.h"
#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

/// The window: what happens becomes a new state, and the state a picture. All that decides anything
/// is in functions of the state; this joins them to SDL.
class Window {
public:
    /// A canvas of the scene's size, and the panel beside it. Throws UsageError or FileError for
    /// the scene, std::runtime_error where there is no display.
    explicit Window(const SceneOptions& scene);

    bool is_open() const { return is_open_; }

    /// One frame: takes the events that wait, draws what has changed. False if nothing had.
    bool step();

    // For who measures and tests:
    const WindowState& state() const { return state_; }
    void set_state(WindowState state) {
        state_ = std::move(state);
        frames_to_draw_ = 1;
    }
    /// That the last pictures took.
    double picture_seconds() const { return milliseconds_ * 1e-3; }
    const Painter& painter(View view) const { return painters_[static_cast<std::size_t>(view)]; }
    /// Of the two views, where both are of one size and drawn.
    const std::optional<Contrast>& contrast() const { return contrast_; }
    const LessonView& lesson_view() const { return lesson_view_; }
    const std::map<std::string, Box>& controls() const {
        return shows_lesson() ? lesson_panel_.places() : panel_.places();
    }
    const std::string& message() const { return message_; }
    /// The whole window as it was last drawn.
    raster::Image8 screenshot() const;

private:
    bool shows_lesson() const { return state_.subject == Subject::lesson; }
    bool take_events();
    void take(const SDL_Event& event);
    void open(const std::string& path);
    void fit_canvas();
    void draw_panel();
    void draw_lesson_panel();
    void paint();
    void paint_subject();
    void paint_views();
    void draw_frame();
    void draw_overlay();
    void draw_panes();
    void copy(const std::string& command_line);
    void fulfil(Wish wish);
    Cameras cameras() const;
    PanelNews news() const;
    void choose_cursor();

    SdlSession session_;
    Sdl<SDL_Window> window_;
    Sdl<SDL_Renderer> renderer_;
    Gui gui_;
    Panel panel_;
    LessonPanel lesson_panel_;
    LessonView lesson_view_;
    ModelShelf shelf_;
    std::array<Painter, 2> painters_;
    std::array<Sheet, 2> sheets_;
    Sheet contrast_sheet_;
    std::array<PixelReader, 2> readers_;
    std::array<Sdl<SDL_Cursor>, 3> cursors_;
    WindowState state_;
    WindowState drawn_;  // the last state of which there are pictures
    std::optional<Contrast> contrast_;
    std::string contrasted_;
    std::string message_;
    double milliseconds_ = 0.0;  // that the last pictures took
    int frames_to_draw_ = 3;     // until all is as the last event wants it
    bool is_open_ = true;
};

}  // namespace scanlight::apps::window
