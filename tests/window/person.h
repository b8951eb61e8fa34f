#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "apps/demo/window/window.h"
#include "apps/scanlight/scene_options.h"
#include "raster/save_image.h"

namespace scanlight::apps::window {

/// A person at the window, who makes events as SDL does.
class Person {
public:
    explicit Person(const std::string& command_line, const std::string& size = "500x900")
        : window_(parse_scene(command_line + " --size " + size)) {
        look();
    }

    Window& window() { return window_; }
    const Window& window() const { return window_; }
    const WindowState& state() const { return window_.state(); }

    void look() {
        for (int i = 0; i < 4; ++i)
            window_.step();
    }
    void move(Point to) {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        event.motion.x = static_cast<int>(to.x);
        event.motion.y = static_cast<int>(to.y);
        push(event);
    }
    void press(Point at) { button(SDL_MOUSEBUTTONDOWN, at); }
    void release(Point at) { button(SDL_MOUSEBUTTONUP, at); }
    void drag(Point from, Point to) {
        move(from);
        press(from);
        move(to);
        release(to);
    }
    void click(Point at) { drag(at, at); }
    void wheel(Point at, int notches) {
        move(at);
        SDL_Event event{};
        event.type = SDL_MOUSEWHEEL;
        event.wheel.y = notches;
        push(event);
    }
    void type(SDL_Keycode key, SDL_Keymod with = KMOD_NONE) { hold(key, 0, with); }
    /// Long enough for the keyboard to repeat it so often.
    void hold(SDL_Keycode key, int repeats, SDL_Keymod with = KMOD_NONE) {
        SDL_Event event{};
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = key;
        event.key.keysym.mod = with;
        push(event);
        event.key.repeat = 1;
        for (int i = 0; i < repeats; ++i)
            push(event);
        event.type = SDL_KEYUP;
        push(event);
    }
    /// Takes the mouse out of the window.
    void leave() {
        SDL_Event event{};
        event.type = SDL_WINDOWEVENT;
        event.window.event = SDL_WINDOWEVENT_LEAVE;
        push(event);
    }
    void drop(const std::string& path) {
        SDL_Event event{};
        event.type = SDL_DROPFILE;
        event.drop.file = SDL_strdup(path.c_str());
        push(event);
    }

    /// The one there is.
    static SDL_Window* sdl_window() {
        for (Uint32 id = 1; id < 1000; ++id) {
            if (SDL_Window* window = SDL_GetWindowFromID(id)) return window;
        }
        return nullptr;
    }

    Box control(const std::string& name) const {
        const auto found = window_.controls().find(name);
        EXPECT_NE(found, window_.controls().end()) << name;
        return found == window_.controls().end() ? Box{} : found->second;
    }
    /// A place on it, as a share of its width.
    Point place_on(const std::string& name, double share) const {
        const Box box = control(name);
        return {box.x + share * box.width, box.y + box.height / 2.0};
    }
    void click_on(const std::string& name) { click(place_on(name, 0.5)); }
    void slide(const std::string& name, double from, double to) {
        drag(place_on(name, from), place_on(name, to));
    }
    /// A word of an open list, by its place in it.
    void choose(const std::string& name, int word) {
        const Box box = control(name);
        click_on(name);
        click({box.x + 30.0, box.y + box.height + 14.0 + 20.0 * word});
    }

private:
    void push(SDL_Event event) {
        SDL_PushEvent(&event);
        look();
    }
    void button(Uint32 type, Point at) {
        SDL_Event event{};
        event.type = type;
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = static_cast<int>(at.x);
        event.button.y = static_cast<int>(at.y);
        push(event);
    }

    Window window_;
};

/// The window under SDL's dummy driver.
class WindowTest : public testing::Test {
protected:
    static void SetUpTestSuite() { setenv("SDL_VIDEODRIVER", "dummy", 1); }

    /// That part of the window's pixels.
    static raster::Image8 part(const raster::Image8& image, const Box& box) {
        raster::Image8 result(box.width, box.height, 3);
        for (int y = 0; y < box.height; ++y) {
            const auto row = image.row(box.y + y).subspan(static_cast<std::size_t>(3 * box.x),
                                                          static_cast<std::size_t>(3 * box.width));
            std::ranges::copy(row, result.row(y).begin());
        }
        return result;
    }

    /// For a person to look at, where asked for.
    static void keep(Person& person, const std::string& name) {
        if (const char* folder = std::getenv("SCANLIGHT_SCREENSHOTS"))
            raster::save_image(std::string(folder) + "/" + name + ".png",
                               person.window().screenshot());
    }
};

}  // namespace scanlight::apps::window
