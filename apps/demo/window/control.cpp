#include "apps/demo/window/control.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <span>
#include <vector>

#include "apps/demo/window/gui.h"
#include "apps/demo/window/round.h"
#include "apps/demo/window/symbol_text.h"
#include "raster/srgb.h"

namespace scanlight::apps::window {

namespace {

constexpr float subscript_drop = 0.38f;  // of the letters' height
constexpr int digits = 3;

std::string id_of(const Parameter& parameter) {
    return "##" + parameter.name;
}

ImGuiSliderFlags flags_of(const Parameter& parameter) {
    return parameter.scale == Scale::logarithmic ? ImGuiSliderFlags_Logarithmic
                                                 : ImGuiSliderFlags_None;
}

// ---- each kind

std::optional<Value> draw_choice(const Parameter& parameter, const std::optional<Value>& value) {
    const std::string current = value ? text_of(*value).value_or("") : "";
    std::optional<Value> chosen;
    if (!ImGui::BeginCombo(id_of(parameter).c_str(), current.c_str())) return chosen;
    for (const std::string& word : parameter.words) {
        if (ImGui::Selectable(word.c_str(), word == current)) chosen = text_value(word);
    }
    ImGui::EndCombo();
    return chosen;
}

std::optional<Value> draw_slider(const Parameter& parameter, const std::optional<Value>& value) {
    auto number = static_cast<float>(value ? number_of(*value).value_or(0.0) : 0.0);
    const bool is_moved =
        ImGui::SliderFloat(id_of(parameter).c_str(), &number, static_cast<float>(parameter.low),
                           static_cast<float>(parameter.high), "%.4g", flags_of(parameter));
    if (!is_moved) return std::nullopt;
    return number_value(rounded(number, std::abs(number), digits));
}

std::optional<Value> draw_whole_slider(const Parameter& parameter,
                                       const std::optional<Value>& value) {
    int number = static_cast<int>(value ? number_of(*value).value_or(0.0) : 0.0);
    const bool is_moved =
        ImGui::SliderInt(id_of(parameter).c_str(), &number, static_cast<int>(parameter.low),
                         static_cast<int>(parameter.high), "%d", flags_of(parameter));
    if (!is_moved) return std::nullopt;
    return whole_value(number);
}

std::optional<Value> draw_check(const Parameter& parameter, const std::optional<Value>& value) {
    bool flag = value && flag_of(*value).value_or(false);
    if (!ImGui::Checkbox(id_of(parameter).c_str(), &flag)) return std::nullopt;
    return flag_value(flag);
}

// ---- colours: how much, and which

float level_of(const glm::vec3& color) {
    return std::max({color.r, color.g, color.b});
}

glm::vec3 with_level(const glm::vec3& color, float level) {
    const float before = level_of(color);
    glm::vec3 scaled = before > 0.0f ? color * (level / before) : glm::vec3(level);
    for (int k = 0; k < 3; ++k)
        scaled[k] = static_cast<float>(rounded(scaled[k], std::max(level, 1e-3f), digits));
    return scaled;
}

std::array<float, 3> srgb_of(const glm::vec3& linear) {
    std::array<float, 3> srgb;
    for (int k = 0; k < 3; ++k)
        srgb[static_cast<std::size_t>(k)] =
            static_cast<float>(raster::srgb_from_linear(linear[k])) / 255.0f;
    return srgb;
}

/// The colours of bytes, which a command line can name.
glm::vec3 linear_of(const std::array<float, 3>& srgb) {
    glm::vec3 linear;
    for (int k = 0; k < 3; ++k) {
        const float byte = std::clamp(srgb[static_cast<std::size_t>(k)], 0.0f, 1.0f) * 255.0f;
        linear[k] = raster::linear_from_srgb(static_cast<std::uint8_t>(std::lround(byte)));
    }
    return linear;
}

std::optional<Value> draw_swatch(const Parameter& parameter, const glm::vec3& color) {
    std::array<float, 3> srgb = srgb_of(color);
    const bool is_changed =
        ImGui::ColorEdit3((id_of(parameter) + " hue").c_str(), srgb.data(),
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip);
    return is_changed ? std::optional(color_value(linear_of(srgb))) : std::nullopt;
}

std::optional<Value> draw_color(const Parameter& parameter, const std::optional<Value>& value) {
    const glm::vec3 color = (value ? color_of(*value) : std::nullopt).value_or(glm::vec3(0.0f));
    std::optional<Value> changed;
    const float room = ImGui::GetContentRegionAvail().x;
    const float swatch = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(room - swatch - 6.0f);
    ImGui::BeginGroup();
    float level = level_of(color);
    if (ImGui::SliderFloat(id_of(parameter).c_str(), &level, 0.0f, 1.0f, "%.3f"))
        changed = color_value(with_level(color, level));
    ImGui::SameLine(0.0f, 6.0f);
    if (const auto picked = draw_swatch(parameter, color)) changed = picked;
    ImGui::EndGroup();
    return changed;
}

}  // namespace

std::optional<Value> draw_control(const Parameter& parameter, const std::optional<Value>& value) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    switch (parameter.control) {
        case Control::choice:
            return draw_choice(parameter, value);
        case Control::slider:
            return draw_slider(parameter, value);
        case Control::whole_slider:
            return draw_whole_slider(parameter, value);
        case Control::color:
            return draw_color(parameter, value);
        case Control::check:
            return draw_check(parameter, value);
    }
    return std::nullopt;
}

Box place_of_item() {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const auto whole = [](float x) { return static_cast<int>(x); };
    return {whole(low.x), whole(low.y), whole(high.x - low.x), whole(high.y - low.y)};
}

void draw_symbol(const std::string& symbol) {
    const auto pieces = pieces_of(symbol);
    ImGui::TextUnformatted(pieces.front().text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 line(ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y);
    const float drop = std::round(subscript_drop * ImGui::GetFontSize());
    float x = line.x;
    for (const auto& [text, place] : std::span(pieces).subspan(1)) {
        const bool is_low = place == SymbolPiece::low;
        ImFont* font = is_low ? subscript_font() : ImGui::GetFont();
        list.AddText(font, font->FontSize, {x, line.y + (is_low ? drop : 0.0f)},
                     ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
        x += font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
    }
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::Dummy({x - line.x, 0.0f});
}

}  // namespace scanlight::apps::window
