#include "apps/demo/window/run_window.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "apps/demo/settings.h"
#include "apps/demo/window/camera_moves.h"
#include "apps/demo/window/frame_times.h"
#include "apps/demo/window/window.h"
#include "apps/scene/stopwatch.h"
#include "raster/save_image.h"

namespace scanlight::apps::window {

namespace {

constexpr double frame_seconds = 1.0 / 60.0;
constexpr int first_frames = 4;  // until the controls have found their places

void draw_first_frames(Window& window) {
    for (int i = 0; i < first_frames; ++i)
        window.step();
}

/// Turned by two degrees a frame, as by a hand: each frame is a new picture.
void turn(Window& window) {
    WindowState state = window.state();
    const render::Camera& camera = window.painter(state.chosen).scene().camera;
    for (SceneOptions& view : state.views)
        view = turned(std::move(view), camera, {5.0, 0.0});
    window.set_state(std::move(state));
}

int measure(Window& window, int frames) {
    draw_first_frames(window);
    std::vector<double> pictures;
    std::vector<double> all;
    for (int i = 0; i < frames; ++i) {
        Stopwatch stopwatch;
        turn(window);
        window.step();
        all.push_back(stopwatch.lap());
        pictures.push_back(window.picture_seconds());
    }
    std::printf("%s\n%s\n", times_text("picture", pictures).c_str(),
                times_text("frame", all).c_str());
    return 0;
}

int take_snapshot(Window& window, const std::string& path) {
    draw_first_frames(window);
    raster::save_image(path, window.screenshot());
    return 0;
}

/// "shading 698 147 185 22": name with - for spaces, corner, width and height, in pixels.
int list_controls(Window& window) {
    draw_first_frames(window);
    for (const auto& [name, box] : window.controls()) {
        std::string word = name;
        std::ranges::replace(word, ' ', '-');
        std::printf("%s %d %d %d %d\n", word.c_str(), box.x, box.y, box.width, box.height);
    }
    return 0;
}

/// Draws when something happens, at most as often as screens show it; else sleeps.
int stay_open(Window& window) {
    while (window.is_open()) {
        Stopwatch stopwatch;
        if (!window.step()) {
            SDL_WaitEventTimeout(nullptr, 250);
            continue;
        }
        const double rest = frame_seconds - stopwatch.lap();
        if (rest > 0.0) SDL_Delay(static_cast<Uint32>(rest * 1e3));
    }
    return 0;
}

LessonState lesson_of(const WindowOptions& options) {
    const demo::Language language = demo::parse_language(options.language);
    if (options.lesson.empty()) return opened(0, language);
    LessonState state = opened(options.lesson, language);
    for (const std::string& assignment : options.assignments)
        demo::set(state.settings, state.lesson(), assignment);
    return state;
}

}  // namespace

int run_window(const WindowOptions& options) {
    const LessonState lesson = lesson_of(options);
    Window window(options.scene);
    WindowState state = window.state();
    state.lesson = lesson;
    window.set_state(options.lesson.empty() ? std::move(state) : with_lesson(state, lesson));
    if (options.measured_frames > 0) return measure(window, options.measured_frames);
    if (!options.snapshot.empty()) return take_snapshot(window, options.snapshot);
    if (options.lists_controls) return list_controls(window);
    return stay_open(window);
}

}  // namespace scanlight::apps::window
