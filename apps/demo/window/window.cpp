#include "apps/demo/window/window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "apps/demo/window/command_line.h"
#include "apps/demo/window/events.h"
#include "apps/demo/window/round.h"
#include "apps/demo/window/saving.h"
#include "apps/demo/window/translate.h"
#include "apps/scene/left_out.h"
#include "apps/scene/stopwatch.h"

namespace scanlight::apps::window {

namespace {

constexpr float frame_seconds = 1.0f / 60.0f;
/// A control answers one frame after its event, and what it changes is seen in the next.
constexpr int frames_after_event = 3;
constexpr raster::Viewport least_canvas{320, 240};

Sdl<SDL_Window> made_window(raster::Viewport canvas) {
    return made(SDL_CreateWindow("Scanlight", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 canvas.width + Panel::width, canvas.height, SDL_WINDOW_RESIZABLE));
}

std::array<Sdl<SDL_Cursor>, 3> made_cursors() {
    return {Sdl<SDL_Cursor>(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_ARROW)),
            Sdl<SDL_Cursor>(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_SIZEWE)),
            Sdl<SDL_Cursor>(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_HAND))};
}

bool is_of_mouse(const SDL_Event& event) {
    return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL;
}

std::string first_left_out(const render::Scene& scene, const SceneOptions& options) {
    const auto sentences = left_out(scene, options);
    return sentences.empty() ? "" : sentences.front();
}

/// Whether a person goes on to something else.
bool begins_anew(const SDL_Event& event) {
    return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_KEYDOWN;
}

/// A number in few letters.
std::string short_number(double number) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

/// "max 37, mean 0.52, 10311 of 921600 pixels"
std::string summary_of(const raster::Difference& d) {
    const double most = d.worst ? std::abs(d.worst->first - d.worst->second) : 0.0;
    return "B \xE2\x88\x92 A:  max " + short_number(most) + ",  mean " +
           short_number(d.mean_absolute) + " of 255,  " + std::to_string(d.different_pixels) +
           " of " + std::to_string(d.pixels) + " pixels differ";
}

}  // namespace

Window::Window(const SceneOptions& scene)
    : window_(made_window(scene.size)),
      renderer_(made(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE))),
      gui_(renderer_.get()),
      painters_{Painter(shelf_), Painter(shelf_)},
      cursors_(made_cursors()),
      state_(window_of(scene)),
      drawn_(state_) {
    SDL_SetWindowMinimumSize(window_.get(), least_canvas.width + Panel::width, least_canvas.height);
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    paint_views();
}

bool Window::step() {
    const bool is_new = take_events() || frames_to_draw_ > 0;
    if (!is_new) return false;
    --frames_to_draw_;
    fit_canvas();
    int width = 0;
    int height = 0;
    SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
    gui_.begin_frame(width, height, frame_seconds);
    if (shows_lesson()) paint();  // the panel has the numbers of the pictures
    shows_lesson() ? draw_lesson_panel() : draw_panel();
    paint();
    draw_overlay();
    draw_frame();
    choose_cursor();
    return true;
}

// ---- events

bool Window::take_events() {
    bool any = false;
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        take(event);
        any = true;
    }
    if (any) frames_to_draw_ = frames_after_event;
    return any;
}

void Window::take(const SDL_Event& event) {
    gui_.take(event);
    if (begins_anew(event)) message_.clear();
    if (event.type == SDL_QUIT) is_open_ = false;
    if (event.type == SDL_DROPFILE) {
        open(event.drop.file);
        SDL_free(event.drop.file);
    }
    if (event.type == SDL_KEYDOWN && gui_.wants_keys()) return;
    if (is_of_mouse(event) && gui_.wants_mouse()) return;
    if (const auto meant = translated(event, state_))
        state_ = shows_lesson() ? after_in_lesson(std::move(state_), *meant, lesson_view_.sight())
                                : after(std::move(state_), *meant, cameras());
}

void Window::open(const std::string& path) {
    try {
        state_ = with_input(state_, path);
        message_ = path;
    } catch (const std::exception& error) {
        message_ = error.what();
    }
}

/// The canvas is what the panel leaves of the window.
void Window::fit_canvas() {
    int width = 0;
    int height = 0;
    SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
    const raster::Viewport canvas{std::max(width - Panel::width, 1), std::max(height, 1)};
    if (canvas.width != state_.canvas.width || canvas.height != state_.canvas.height)
        state_ = on_canvas(std::move(state_), canvas);
}

// ---- pictures

void Window::paint() {
    try {
        paint_subject();
        drawn_ = state_;
    } catch (const std::exception& error) {  // what can't be drawn is not taken over
        message_ = error.what();
        state_ = drawn_;
        paint_subject();
    }
}

void Window::paint_subject() {
    if (shows_lesson()) {
        lesson_view_.paint(state_.lesson, state_.canvas);
    } else {
        paint_views();
    }
}

/// Those that are seen.
void Window::paint_views() {
    Stopwatch stopwatch;
    const auto needs = [&](View view) {
        return state_.arrangement != Arrangement::one || view == state_.chosen;
    };
    bool is_new = false;
    for (const View view : {View::left, View::right}) {
        Painter& painter = painters_[static_cast<std::size_t>(view)];
        const std::string before = painter.drawn();
        if (needs(view)) painter.paint(state_.of(view));
        is_new = is_new || painter.drawn() != before;
    }
    const std::string both = painters_[0].drawn() + "\n" + painters_[1].drawn();
    if (state_.arrangement == Arrangement::difference && both != contrasted_) {
        contrast_ = contrast_of(painters_[0].pixels(), painters_[1].pixels());
        contrasted_ = both;
    }
    if (is_new) milliseconds_ = stopwatch.lap() * 1e3;
}

Cameras Window::cameras() const {
    const auto& [left, right] = painters_;
    const auto camera_of = [&](const Painter& painter, const Painter& instead) {
        return painter.drawn().empty() ? instead.scene().camera : painter.scene().camera;
    };
    return {camera_of(left, right), camera_of(right, left)};
}

// ---- what is seen

PanelNews Window::news() const {
    const Painter& shown = painter(drawn_.chosen);
    PanelNews news;
    news.message = message_;
    news.picture_milliseconds = milliseconds_;
    if (shown.drawn().empty()) return news;
    if (news.message.empty()) news.message = first_left_out(shown.scene(), drawn_.current());
    news.polygons = totals_of(shown.models()).report.drawn;
    const auto& objects = shown.scene().objects;
    if (!objects.empty() && !objects.front().materials.empty())
        news.material = objects.front().materials.front();
    const mesh::Box& box = shown.models().box;
    const double size = std::max({box.size().x, box.size().y, box.size().z, 1e-12});
    news.lamp = rounded(box.center() + box.size() * glm::dvec3(0.4, 0.9, 0.6), size, 3);
    return news;
}

void Window::draw_lesson_panel() {
    LessonPanel::Result result =
        lesson_panel_.draw(std::move(state_), lesson_view_.sight(), message_, drawn_.canvas.width,
                           drawn_.canvas.height);
    state_ = std::move(result.state);
    if (!result.to_copy.empty()) copy(result.to_copy);
    if (result.wish != Wish::nothing) fulfil(result.wish);
}

void Window::draw_panel() {
    Panel::Result result =
        panel_.draw(std::move(state_), news(), state_.canvas.width, state_.canvas.height);
    state_ = std::move(result.state);
    if (result.wish != Wish::nothing) fulfil(result.wish);
}

void Window::draw_overlay() {
    if (shows_lesson()) {
        lesson_view_.draw_words(state_.lesson);
        return;
    }
    draw_marks(state_, cameras());
    if (state_.arrangement == Arrangement::difference && contrast_)
        draw_label(summary_of(contrast_->difference), {10.0, 10.0});
    const auto picked = picked_pixel(state_);
    if (!picked || is_dragging(state_)) return;
    const auto index = static_cast<std::size_t>(picked->view);
    const SceneOptions& options = state_.of(picked->view);
    const auto pixel = readers_[index].at(painters_[index], options, picked->x, picked->y);
    draw_loupe(*picked, pixel, painters_[index], options, state_.canvas);
}

void Window::draw_frame() {
    SDL_SetRenderDrawColor(renderer_.get(), 30, 30, 32, 255);
    SDL_RenderClear(renderer_.get());
    shows_lesson() ? lesson_view_.draw_pictures(renderer_.get()) : draw_panes();
    gui_.draw(renderer_.get());
    SDL_RenderPresent(renderer_.get());
}

void Window::draw_panes() {
    for (const Pane& pane : panes_of(state_)) {
        const auto index = static_cast<std::size_t>(pane.view);
        const bool is_contrast = state_.arrangement == Arrangement::difference && contrast_;
        Sheet& sheet = is_contrast ? contrast_sheet_ : sheets_[index];
        const Painter& painter = painters_[index];
        sheet.show(is_contrast ? contrast_->pixels : painter.pixels(),
                   is_contrast ? contrasted_ : painter.drawn(), renderer_.get());
        sheet.draw(pane, renderer_.get());
    }
}

void Window::choose_cursor() {
    if (shows_lesson()) {
        const bool can_point = state_.mouse && !gui_.wants_mouse() &&
                               can_point_at(state_.lesson, *state_.mouse, lesson_view_.sight());
        SDL_SetCursor(cursors_[can_point ? 2 : 0].get());
        return;
    }
    const Target target = state_.mouse && !gui_.wants_mouse()
                              ? target_at(state_, *state_.mouse, cameras())
                              : Target::nothing;
    const std::size_t cursor = target == Target::divider ? 1 : target == Target::light ? 2 : 0;
    if (cursors_[cursor] != nullptr) SDL_SetCursor(cursors_[cursor].get());
}

void Window::fulfil(Wish wish) {
    try {
        const SceneOptions& view = state_.current();
        if (wish == Wish::save_picture && shows_lesson()) {
            message_ = save_lesson(lesson_view_.screen(), state_.lesson);
            return;
        }
        if (wish == Wish::save_picture)
            message_ = save_picture(painter(state_.chosen).pixels(), view);
        if (wish == Wish::save_scene) message_ = save_scene(view);
        if (wish == Wish::copy_command_line) copy(command_line_of(view));
    } catch (const std::exception& error) {
        message_ = error.what();
    }
}

void Window::copy(const std::string& command_line) {
    message_ = command_line;
    SDL_SetClipboardText(message_.c_str());
}

raster::Image8 Window::screenshot() const {
    int width = 0;
    int height = 0;
    SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
    raster::Image8 image(width, height, 3);
    SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_RGB24, image.samples().data(),
                         3 * width);
    return image;
}

}  // namespace scanlight::apps::window
