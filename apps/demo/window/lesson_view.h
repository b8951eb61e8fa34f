#pragma once

#include <string>
#include <vector>

#include "apps/demo/window/canvas.h"
#include "apps/demo/window/lesson_events.h"
#include "apps/demo/window/lesson_layout.h"

namespace scanlight::apps::window {

/// What the canvas shows of a lesson: pictures, plots and tables. Drawn anew only when the lesson
/// stands otherwise, or the canvas is another.
class LessonView {
public:
    /// Throws as the lesson's draw does, and keeps what there was.
    void paint(const LessonState& state, raster::Viewport canvas);

    const demo::Screen& screen() const { return screen_; }
    LessonSight sight() const { return {screen_, pictures_, panel_}; }
    /// Tells what is drawn, and how large; empty before the first.
    const std::string& drawn() const { return drawn_; }

    void draw_pictures(SDL_Renderer* renderer);
    /// Between two calls of Gui: captions, plots and tables.
    void draw_words(const LessonState& state) const;

private:
    demo::Screen screen_;
    LessonLayout layout_;
    std::vector<Box> pictures_;
    raster::Viewport panel_;
    std::vector<Sheet> sheets_;
    std::string drawn_;
};

}  // namespace scanlight::apps::window
