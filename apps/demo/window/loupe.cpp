#include "apps/demo/window/loupe.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "apps/demo/window/control.h"
#include "shading/vector.h"

namespace scanlight::apps::window {

namespace {

constexpr int reach = 6;  // pixels each way
constexpr float magnified = 11.0f;

std::string number_text(double number) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.4f", number);
    return text.data();
}

// ---- enlarged pixels

void draw_magnified(const PickedPixel& picked, const Pixels& pixels) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const auto square = [&](int x, int y) {
        const ImVec2 low(corner.x + static_cast<float>(x + reach) * magnified,
                         corner.y + static_cast<float>(y + reach) * magnified);
        return std::pair(low, ImVec2(low.x + magnified, low.y + magnified));
    };
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const int px = picked.x + x;
            const int py = picked.y + y;
            if (px < 0 || py < 0 || px >= pixels.width() || py >= pixels.height()) continue;
            const auto [low, high] = square(x, y);
            list.AddRectFilled(low, high, pixels.at(px, py) | 0xff000000u);
        }
    }
    const auto [low, high] = square(0, 0);
    list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, IM_COL32(0, 0, 0, 255));
    list.AddRect(low, high, IM_COL32(255, 255, 255, 255));
    const float side = (2 * reach + 1) * magnified;
    ImGui::Dummy({side, side});
}

// ---- rows of numbers

void begin_row(const char* symbol) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_symbol(symbol);
    ImGui::TableNextColumn();
}

void row(const char* symbol, const std::string& text) {
    begin_row(symbol);
    ImGui::TextUnformatted(text.c_str());
}

/// Three numbers, each in a column of its own.
void row(const char* symbol, const glm::vec3& v) {
    begin_row(symbol);
    for (int k = 0; k < 3; ++k) {
        if (k > 0) ImGui::SameLine(static_cast<float>(k) * 74.0f);
        ImGui::Text("%8.4f", v[k]);
    }
}

/// Its colour and, of one that does not fill space, where this is on it.
void draw_texture(const render::TextureAtPixel& texture) {
    row((std::string(texture.slot) + " map").c_str(), texture.color);
    if (texture.uv) row("u, v", number_text(texture.uv->x) + "   " + number_text(texture.uv->y));
}

void draw_facets(const render::FacetTerms& facets) {
    row("D", number_text(facets.D) + "   G " + number_text(facets.G));
    row("F", facets.F);
}

void draw_place(const PickedPixel& picked, const render::PixelLight& pixel) {
    row("pixel", std::to_string(picked.x) + ", " + std::to_string(picked.y) + "   polygon " +
                     std::to_string(pixel.polygon));
    row("depth", number_text(raster::ndc_from_depth(pixel.depth)) + "   distance " +
                     number_text(pixel.distance));
    row("point", pixel.point);
    row("N", pixel.N);
    row("V", pixel.V);
    if (pixel.vertex_color) row("vertices", *pixel.vertex_color);
    for (const render::TextureAtPixel& texture : pixel.textures)
        draw_texture(texture);
    row("K_d", pixel.K_d);
    row("K_s", pixel.K_s);
    row("n", number_text(pixel.exponent));
    row("I_a K_a", pixel.ambient);
}

/// "N.L 0.71   R.V 0.93   N.H 0.97"
std::string cosines_of(const render::PixelLight& pixel, const render::LightAtPixel& light) {
    return "N\xC2\xB7L " + number_text(shading::dot(pixel.N, light.L)) + "  R\xC2\xB7V " +
           number_text(shading::dot(light.R, pixel.V)) + "  N\xC2\xB7H " +
           number_text(shading::dot(pixel.N, light.H));
}

std::string reach_of(const render::LightAtPixel& light, const SceneOptions& options) {
    std::string text = number_text(light.share);
    if (render::counts_volumes(options.settings.shadows))
        text += "   stencil " + std::to_string(light.stencil);
    if (std::isfinite(light.distance)) text += "   r " + number_text(light.distance);
    return text;
}

void draw_light(const render::PixelLight& pixel, const render::LightAtPixel& light,
                const SceneOptions& options) {
    row("L", light.L);
    row("R", light.R);
    row("H", light.H);
    row("", cosines_of(pixel, light));
    row("I_p", light.intensity);
    row("diffuse", light.body);
    row("specular", light.highlight);
    if (light.facets) draw_facets(*light.facets);
    row("lit", reach_of(light, options));
}

std::string bytes_text(raster::PackedPixel pixel) {
    return std::to_string(pixel & 0xff) + ", " + std::to_string(pixel >> 8 & 0xff) + ", " +
           std::to_string(pixel >> 16 & 0xff);
}

/// What the numbers leave out.
void draw_notes(const SceneOptions& options) {
    if (options.settings.shading != render::Shading::phong)
        ImGui::TextDisabled("Terms as Phong shading has them; this view interpolates.");
    if (options.settings.grid > 1)
        ImGui::TextDisabled("Of the pixel's centre; this view averages samples.");
}

void draw_numbers(const PickedPixel& picked, const std::optional<render::PixelLight>& pixel,
                  const Painter& painter, const SceneOptions& options) {
    const Pixels& pixels = painter.pixels();
    if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingFixedFit)) return;
    if (pixel) {
        draw_place(picked, *pixel);
        for (const auto& light : pixel->lights)
            draw_light(*pixel, light, options);
        row("I", pixel->intensity);
    } else {
        row("pixel",
            std::to_string(picked.x) + ", " + std::to_string(picked.y) + "   the background");
    }
    row("sRGB", bytes_text(pixels.at(picked.x, picked.y)));
    ImGui::EndTable();
    if (pixel) draw_notes(options);
}

/// In the lower corner that is farther from the point.
void place_window(Point point, raster::Viewport canvas) {
    const bool is_left = point.x * 2 > canvas.width;
    const auto x = is_left ? 10.0f : static_cast<float>(canvas.width) - 10.0f;
    ImGui::SetNextWindowPos({x, static_cast<float>(canvas.height) - 10.0f}, ImGuiCond_Always,
                            {is_left ? 0.0f : 1.0f, 1.0f});
}

}  // namespace

std::optional<PickedPixel> picked_pixel(const WindowState& state) {
    const std::optional<Point> point = state.picked ? state.picked : state.mouse;
    if (!point || state.loupe == Loupe::closed) return std::nullopt;
    const auto pane = pane_at(state, *point);
    if (!pane) return std::nullopt;
    return PickedPixel{pane->view, static_cast<int>(point->x) - pane->picture.x,
                       static_cast<int>(point->y) - pane->picture.y, *point};
}

std::optional<render::PixelLight> PixelReader::at(const Painter& painter,
                                                  const SceneOptions& options, int x, int y) {
    if (drawn_ != painter.drawn()) {
        lights_ =
            std::make_unique<render::PixelLights>(painter.scene(), options.settings, options.size);
        drawn_ = painter.drawn();
    }
    return lights_->at(x, y);
}

void draw_loupe(const PickedPixel& picked, const std::optional<render::PixelLight>& pixel,
                const Painter& painter, const SceneOptions& options, raster::Viewport canvas) {
    place_window(picked.at, canvas);
    ImGui::SetNextWindowBgAlpha(0.93f);
    ImGui::Begin("loupe", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    draw_magnified(picked, painter.pixels());
    ImGui::SameLine(0.0f, 14.0f);
    ImGui::BeginGroup();
    draw_numbers(picked, pixel, painter, options);
    ImGui::EndGroup();
    ImGui::End();
}

}  // namespace scanlight::apps::window
