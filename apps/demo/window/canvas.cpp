#include "apps/demo/window/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "apps/demo/window/light_handles.h"
#include "apps/scene/words.h"
#include "raster/srgb.h"

namespace scanlight::apps::window {

namespace {

constexpr float handle_radius = 8.0f;
constexpr ImU32 dark = IM_COL32(20, 21, 24, 215);
constexpr ImU32 light = IM_COL32(240, 242, 246, 255);
constexpr ImU32 faint = IM_COL32(20, 21, 24, 70);

ImVec2 place(Point p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

ImU32 color_of(const glm::vec3& linear) {
    return IM_COL32(raster::srgb_from_linear(linear.r), raster::srgb_from_linear(linear.g),
                    raster::srgb_from_linear(linear.b), 255);
}

void draw_handle(const LightHandle& handle) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 at = place(handle.at);
    list.AddCircleFilled(at, handle_radius + 2.0f, dark, 24);
    if (handle.is_behind) {
        list.AddCircle(at, handle_radius - 1.0f, color_of(handle.color), 24, 2.5f);
    } else {
        list.AddCircleFilled(at, handle_radius, color_of(handle.color), 24);
    }
}

/// Where lights at infinity come from the side, and from behind.
void draw_light_circles(const Box& picture) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 middle(static_cast<float>(picture.x) + static_cast<float>(picture.width) / 2,
                        static_cast<float>(picture.y) + static_cast<float>(picture.height) / 2);
    const auto radius = static_cast<float>(light_circle(picture));
    list.AddCircle(middle, radius, faint, 64, 1.0f);
    list.AddCircle(middle, 2.0f * radius, faint, 96, 1.0f);
}

void draw_lights(const Pane& pane, const WindowState& state, const Cameras& cameras) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Box& box = pane.visible;
    list.PushClipRect(
        place({static_cast<double>(box.x), static_cast<double>(box.y)}),
        place({static_cast<double>(box.x + box.width), static_cast<double>(box.y + box.height)}));
    if (std::holds_alternative<MovingLight>(state.drag)) draw_light_circles(pane.picture);
    const auto& camera = cameras[static_cast<std::size_t>(pane.view)];
    for (const LightHandle& handle : light_handles(state.of(pane.view), camera, pane.picture))
        draw_handle(handle);
    list.PopClipRect();
}

void draw_divider(const WindowState& state) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto x = static_cast<float>(divider_column(state));
    const auto height = static_cast<float>(state.canvas.height);
    const auto bar = [&](float half_width, float low, float high, ImU32 color) {
        list.AddRectFilled({x - half_width, low}, {x + half_width, high}, color);
    };
    bar(2.0f, 0.0f, height, dark);
    bar(1.0f, 0.0f, height, light);
    bar(6.0f, height / 2 - 22.0f, height / 2 + 22.0f, dark);
    bar(4.0f, height / 2 - 20.0f, height / 2 + 20.0f, light);
}

void draw_names(const WindowState& state) {
    for (const Pane& pane : panes_of(state)) {
        const char* letter = pane.view == View::left ? "A  " : "B  ";
        draw_label(letter + name_of(state.of(pane.view)),
                   {pane.visible.x + 10.0, pane.visible.y + 10.0},
                   pane.view == state.chosen ? Look::chosen : Look::plain);
    }
}

/// Red and blue change places.
raster::PackedPixel turned(raster::PackedPixel pixel) {
    return (pixel & 0xff00ff00u) | (pixel & 0xffu) << 16 | (pixel >> 16 & 0xffu);
}

/// As screens order their bytes, so that SDL can copy them as they are: left to it, putting them in
/// that order takes as long as drawing them.
void copy(const Pixels& pixels, SDL_Texture& texture) {
    void* rows = nullptr;
    int pitch = 0;
    if (SDL_LockTexture(&texture, nullptr, &rows, &pitch) != 0) return;
    for (int y = 0; y < pixels.height(); ++y) {
        auto* row = static_cast<std::uint8_t*>(rows) + static_cast<std::ptrdiff_t>(y) * pitch;
        std::ranges::transform(pixels.row(y), reinterpret_cast<raster::PackedPixel*>(row), turned);
    }
    SDL_UnlockTexture(&texture);
}

}  // namespace

void Sheet::show(const Pixels& pixels, const std::string& name, SDL_Renderer* renderer) {
    if (shows(name)) return;
    if (texture_ == nullptr || pixels.width() != width_ || pixels.height() != height_) {
        width_ = pixels.width();
        height_ = pixels.height();
        texture_ = made(SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888,
                                          SDL_TEXTUREACCESS_STREAMING, width_, height_));
        SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE);
    }
    copy(pixels, *texture_);
    name_ = name;
}

void Sheet::draw(const Pane& pane, SDL_Renderer* renderer) const {
    const Box& seen = pane.visible;
    const SDL_Rect from{seen.x - pane.picture.x, seen.y - pane.picture.y, seen.width, seen.height};
    const SDL_Rect to{seen.x, seen.y, seen.width, seen.height};
    SDL_RenderCopy(renderer, texture_.get(), &from, &to);
}

void draw_marks(const WindowState& state, const Cameras& cameras) {
    if (state.arrangement != Arrangement::difference) {
        for (const Pane& pane : panes_of(state))
            draw_lights(pane, state, cameras);
    }
    if (has_divider(state)) draw_divider(state);
    if (state.arrangement != Arrangement::difference) draw_names(state);
}

std::string name_of(const SceneOptions& options) {
    const render::Settings& s = options.settings;
    std::string name = word_of(s.shading) + ", " + word_of(s.illumination);
    if (options.polygons == Polygons::triangulated) name += ", triangulated";
    if (s.perspective == render::Perspective::affine) name += ", affine";
    if (s.shadows != render::Shadows::none) name += ", shadows " + word_of(s.shadows);
    if (options.show != Show::light) name += ", " + word_of(options.show);
    return name;
}

void draw_label(const std::string& text, Point at, Look look) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 low = place(at);
    const ImVec2 high(low.x + size.x + 16.0f, low.y + size.y + 8.0f);
    list.AddRectFilled(low, high, dark);
    if (look == Look::chosen)
        list.AddRectFilled(low, {low.x + 3.0f, high.y}, ImGui::GetColorU32(ImGuiCol_SliderGrab));
    list.AddText({low.x + 9.0f, low.y + 4.0f}, light, text.c_str());
}

}  // namespace scanlight::apps::window
