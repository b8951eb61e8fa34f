#include "apps/demo/window/translate.h"

#include <SDL.h>

#include <utility>

namespace scanlight::apps::window {

namespace {

bool is_on_canvas(Point p, const WindowState& state) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x < state.canvas.width && p.y < state.canvas.height;
}

Button button_of(Uint8 sdl_button) {
    if (sdl_button == SDL_BUTTON_LEFT) return Button::left;
    return sdl_button == SDL_BUTTON_MIDDLE ? Button::middle : Button::right;
}

Event moved(const SDL_MouseMotionEvent& motion, const WindowState& state) {
    const Point to{static_cast<double>(motion.x), static_cast<double>(motion.y)};
    if (is_dragging(state) || is_on_canvas(to, state)) return Move{to};
    return Leave{};
}

std::optional<Event> pressed(const SDL_MouseButtonEvent& button, const WindowState& state) {
    const Point at{static_cast<double>(button.x), static_cast<double>(button.y)};
    if (!is_on_canvas(at, state)) return std::nullopt;
    const bool is_shifted = (SDL_GetModState() & KMOD_SHIFT) != 0;
    return Press{at, button_of(button.button), is_shifted};
}

constexpr std::pair<SDL_Keycode, NamedKey> named_keys[] = {
    {SDLK_LEFT, NamedKey::left},      {SDLK_RIGHT, NamedKey::right},
    {SDLK_UP, NamedKey::up},          {SDLK_DOWN, NamedKey::down},
    {SDLK_HOME, NamedKey::home},      {SDLK_END, NamedKey::end},
    {SDLK_PAGEUP, NamedKey::page_up}, {SDLK_PAGEDOWN, NamedKey::page_down},
    {SDLK_ESCAPE, NamedKey::escape},
};

std::optional<NamedKey> named(SDL_Keycode code) {
    for (const auto& [sdl_code, key] : named_keys) {
        if (sdl_code == code) return key;
    }
    return std::nullopt;
}

std::optional<Nudge> nudge_of(SDL_Keycode code) {
    switch (code) {
        case SDLK_LEFT:
            return Nudge{-1, 0};
        case SDLK_RIGHT:
            return Nudge{1, 0};
        case SDLK_UP:
            return Nudge{0, 1};
        case SDLK_DOWN:
            return Nudge{0, -1};
        default:
            return std::nullopt;
    }
}

std::optional<Event> typed(const SDL_KeyboardEvent& key) {
    const SDL_Keycode code = key.keysym.sym;
    if ((key.keysym.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0) return std::nullopt;
    const bool is_shifted = (key.keysym.mod & KMOD_SHIFT) != 0;
    if (const auto nudge = nudge_of(code); nudge && is_shifted) return *nudge;
    if (const auto name = named(code)) return *name;
    if (key.repeat != 0) return std::nullopt;  // letters switch: held too long, by chance
    if (code == SDLK_TAB) return Key{'\t'};
    if (code < ' ' || code > '~') return std::nullopt;
    return Key{static_cast<char>(code)};
}

}  // namespace

bool leaves_window(const SDL_Event& event) {
    return event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE;
}

std::optional<Event> translated(const SDL_Event& event, const WindowState& state) {
    switch (event.type) {
        case SDL_WINDOWEVENT:
            return leaves_window(event) && !is_dragging(state) ? std::optional<Event>(Leave{})
                                                               : std::nullopt;
        case SDL_MOUSEMOTION:
            return moved(event.motion, state);
        case SDL_MOUSEBUTTONDOWN:
            return pressed(event.button, state);
        case SDL_MOUSEBUTTONUP:
            return Release{};
        case SDL_MOUSEWHEEL:
            if (!state.mouse) return std::nullopt;
            return Wheel{static_cast<double>(event.wheel.y)};
        case SDL_KEYDOWN:
            return typed(event.key);
        default:
            return std::nullopt;
    }
}

}  // namespace scanlight::apps::window
