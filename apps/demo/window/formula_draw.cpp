#include "apps/demo/window/formula_draw.h"

#include <imgui.h>

#include <cfloat>

#include "apps/demo/window/formula.h"
#include "apps/demo/window/gui.h"

namespace scanlight::apps::window {

namespace {

ImFont* font_of(LetterSize size) {
    return size == LetterSize::low ? subscript_font() : ImGui::GetFont();
}

Letters letters() {
    const auto width = [](const std::string& text, LetterSize size) -> double {
        const ImFont* font = font_of(size);
        return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
    };
    const ImFont* normal = font_of(LetterSize::normal);
    const ImFont* low = font_of(LetterSize::low);
    return {width, {normal->Ascent, low->Ascent}, {-normal->Descent, -low->Descent}};
}

void draw_text(const FormulaText& text, const ImVec2& origin) {
    const ImFont* font = font_of(text.size);
    const ImVec2 at(origin.x + static_cast<float>(text.x),
                    origin.y + static_cast<float>(text.y) - font->Ascent);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    list.AddText(font, font->FontSize, at, color, text.text.c_str());
    if (text.weight == Weight::bold)
        list.AddText(font, font->FontSize, {at.x + 1.0f, at.y}, color, text.text.c_str());
}

void draw_line(const Formula& line) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 origin(corner.x, corner.y + static_cast<float>(line.ascent));
    for (const FormulaText& text : line.texts)
        draw_text(text, origin);
    for (const FormulaRule& rule : line.rules) {
        const float y = origin.y + static_cast<float>(rule.y);
        ImGui::GetWindowDrawList()->AddRectFilled({origin.x + static_cast<float>(rule.begin), y},
                                                  {origin.x + static_cast<float>(rule.end), y + 1},
                                                  ImGui::GetColorU32(ImGuiCol_Text));
    }
    ImGui::Dummy(
        {static_cast<float>(line.width), static_cast<float>(line.ascent + line.descent) + 2.0f});
}

}  // namespace

void draw_formula(const std::string& mathml) {
    for (const Formula& line : formula_lines(mathml, letters()))
        draw_line(line);
}

}  // namespace scanlight::apps::window
