#include "apps/demo/window/code_draw.h"

#include <imgui.h>

#include <algorithm>

#include "apps/demo/window/gui.h"

namespace scanlight::apps::window {

namespace {

enum class Line { resting, at_work };

void draw_line(const std::string& line, Line kind) {
    if (kind == Line::at_work) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const ImVec2 high(low.x + width,
                          low.y + ImGui::CalcTextSize(line.c_str(), nullptr, false, width).y);
        ImGui::GetWindowDrawList()->AddRectFilled(low, high, IM_COL32(42, 74, 120, 255));
    }
    const ImGuiCol color = kind == Line::at_work ? ImGuiCol_Text : ImGuiCol_TextDisabled;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(color));
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(line.empty() ? " " : line.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

}  // namespace

void draw_code(const demo::Excerpt& excerpt, const std::string& title, const Box& box) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 1.0f});
    ImGui::PushFont(small_font());
    ImGui::Begin("code", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground);
    ImGui::TextUnformatted((title + ": " + excerpt.file).c_str());
    for (std::size_t i = 0; i < excerpt.lines.size(); ++i) {
        const bool is_at_work = std::ranges::find(excerpt.at_work, i) != excerpt.at_work.end();
        draw_line(excerpt.lines[i], is_at_work ? Line::at_work : Line::resting);
    }
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleVar(2);
}

}  // namespace scanlight::apps::window
