#include "apps/demo/window/paragraph.h"

#include <imgui.h>

#include <cfloat>
#include <cmath>

#include "apps/demo/window/gui.h"
#include "apps/demo/window/symbol_text.h"

namespace scanlight::apps::window {

namespace {

constexpr float subscript_drop = 0.38f;  // of the letters' height

ImFont* font_of(const SymbolPiece& piece) {
    return piece.place == SymbolPiece::low ? subscript_font() : ImGui::GetFont();
}

float width_of(const SymbolPiece& piece) {
    const ImFont* font = font_of(piece);
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, piece.text.c_str()).x;
}

float width_of(const std::string& word) {
    float width = 0.0f;
    for (const SymbolPiece& piece : pieces_of(word))
        width += width_of(piece);
    return width;
}

std::string without_blank(std::string word) {
    if (word.ends_with(' ')) word.pop_back();
    return word;
}

void draw_word(const std::string& word, ImVec2 at) {
    const float drop = std::round(subscript_drop * ImGui::GetFontSize());
    for (const SymbolPiece& piece : pieces_of(word)) {
        const ImFont* font = font_of(piece);
        const float y = piece.place == SymbolPiece::low ? at.y + drop : at.y;
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {at.x, y},
                                            ImGui::GetColorU32(ImGuiCol_Text), piece.text.c_str());
        at.x += width_of(piece);
    }
}

}  // namespace

void draw_paragraph(const std::string& text) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    ImVec2 at = corner;
    for (const std::string& word : words_of(text)) {
        const bool fits = at.x + width_of(without_blank(word)) <= corner.x + room;
        if (!fits && at.x > corner.x) at = {corner.x, at.y + line};
        draw_word(word, at);
        at.x += width_of(word);
    }
    ImGui::Dummy({room, at.y + line - corner.y});
}

}  // namespace scanlight::apps::window
