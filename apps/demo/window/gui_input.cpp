#include "apps/demo/window/gui_input.h"

#include <SDL.h>
#include <imgui.h>

#include <cfloat>
#include <optional>
#include <utility>

#include "apps/demo/window/translate.h"

namespace scanlight::apps::window {

namespace {

constexpr std::pair<ImGuiKey_, SDL_Scancode> keys[] = {{ImGuiKey_Tab, SDL_SCANCODE_TAB},
                                                       {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
                                                       {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
                                                       {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
                                                       {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
                                                       {ImGuiKey_Home, SDL_SCANCODE_HOME},
                                                       {ImGuiKey_End, SDL_SCANCODE_END},
                                                       {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
                                                       {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
                                                       {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
                                                       {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
                                                       {ImGuiKey_A, SDL_SCANCODE_A},
                                                       {ImGuiKey_C, SDL_SCANCODE_C},
                                                       {ImGuiKey_V, SDL_SCANCODE_V},
                                                       {ImGuiKey_X, SDL_SCANCODE_X},
                                                       {ImGuiKey_Z, SDL_SCANCODE_Z}};

std::optional<std::size_t> button_of(Uint8 sdl_button) {
    switch (sdl_button) {
        case SDL_BUTTON_LEFT:
            return 0;
        case SDL_BUTTON_RIGHT:
            return 1;
        case SDL_BUTTON_MIDDLE:
            return 2;
        default:
            return std::nullopt;
    }
}

void take_key(const SDL_KeyboardEvent& key) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[key.keysym.scancode] = key.type == SDL_KEYDOWN;
    io.KeyShift = (key.keysym.mod & KMOD_SHIFT) != 0;
    io.KeyCtrl = (key.keysym.mod & KMOD_CTRL) != 0;
    io.KeyAlt = (key.keysym.mod & KMOD_ALT) != 0;
}

}  // namespace

GuiInput::GuiInput() {
    for (const auto& [key, scancode] : keys)
        ImGui::GetIO().KeyMap[key] = scancode;
}

void GuiInput::take(const SDL_Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.type) {
        case SDL_MOUSEMOTION:
            io.MousePos = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
            break;
        case SDL_WINDOWEVENT:
            if (leaves_window(event)) io.MousePos = {-FLT_MAX, -FLT_MAX};
            break;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            if (const auto button = button_of(event.button.button)) {
                is_held_[*button] = event.type == SDL_MOUSEBUTTONDOWN;
                was_pressed_[*button] |= is_held_[*button];
            }
            break;
        case SDL_MOUSEWHEEL:
            io.MouseWheel += static_cast<float>(event.wheel.y);
            break;
        case SDL_TEXTINPUT:
            io.AddInputCharactersUTF8(event.text.text);
            break;
        case SDL_KEYDOWN:
        case SDL_KEYUP:
            take_key(event.key);
            break;
        default:
            break;
    }
}

void GuiInput::begin_frame(int width, int height, float seconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = seconds;
    for (std::size_t i = 0; i < is_held_.size(); ++i) {
        const bool was_pressed = std::exchange(was_pressed_[i], false);
        io.MouseDown[i] = is_held_[i] || was_pressed;
    }
}

}  // namespace scanlight::apps::window
