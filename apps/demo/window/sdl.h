#pragma once

#include <SDL.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scanlight::apps::window {

/// SDL itself, for as long as it is used.
class SdlSession {
public:
    /// Throws std::runtime_error where there is no display.
    SdlSession() {
        // What is dear the rasterizer has drawn already. Without OpenGL, which SDL else would take
        // to bring even these pixels to the screen, there is a driver less to be missing.
        SDL_SetHint(SDL_HINT_RENDER_DRIVER, "software");
        SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        if (SDL_Init(SDL_INIT_VIDEO) != 0)
            throw std::runtime_error(std::string("no window: ") + SDL_GetError());
        if (!is_seen()) {
            SDL_Quit();
            throw std::runtime_error("no window: there is no display");
        }
    }
    ~SdlSession() { SDL_Quit(); }
    SdlSession(const SdlSession&) = delete;
    SdlSession& operator=(const SdlSession&) = delete;

private:
    /// Without a display SDL opens windows that no one sees; that is for those who ask for it.
    static bool is_seen() {
        const std::string_view driver = SDL_GetCurrentVideoDriver();
        const bool is_asked_for = std::getenv("SDL_VIDEODRIVER") != nullptr;
        return is_asked_for || (driver != "offscreen" && driver != "dummy");
    }
};

/// What SDL made, and how it is given back.
struct SdlDelete {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
    void operator()(SDL_Cursor* cursor) const { SDL_FreeCursor(cursor); }
};
template <class T>
using Sdl = std::unique_ptr<T, SdlDelete>;

/// Throws std::runtime_error unless SDL made it.
template <class T>
Sdl<T> made(T* handle) {
    if (handle == nullptr) throw std::runtime_error(std::string("no window: ") + SDL_GetError());
    return Sdl<T>(handle);
}

}  // namespace scanlight::apps::window
