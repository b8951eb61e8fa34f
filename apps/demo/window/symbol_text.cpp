#include "apps/demo/window/symbol_text.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace scanlight::apps::window {

namespace {

/// What no line begins with.
constexpr std::string_view closing_marks[] = {" ", "。", "，", "、", "；", "：", "）", "！", "？"};

/// How many bytes a UTF-8 character has that begins so.
std::size_t length_of(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0xc0 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

/// CJK marks and characters, and their full-width forms.
bool is_chinese(std::string_view character) {
    return character.size() == 3 && (character >= "\xE3\x80\x80" && character < "\xEA\x80\x80");
}

bool closes(std::string_view character) {
    return std::ranges::find(closing_marks, character) != std::end(closing_marks);
}

}  // namespace

std::vector<SymbolPiece> pieces_of(const std::string& symbol) {
    std::vector<SymbolPiece> pieces{{"", SymbolPiece::on_line}};
    for (const char c : symbol) {
        const bool is_low = pieces.back().place == SymbolPiece::low;
        const bool ends = is_low && std::isalnum(static_cast<unsigned char>(c)) == 0;
        if (ends) pieces.push_back({"", SymbolPiece::on_line});
        if (c == '_') {
            pieces.push_back({"", SymbolPiece::low});
        } else {
            pieces.back().text += c;
        }
    }
    return pieces;
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words{""};
    bool is_broken = false;  // after the character before
    for (std::size_t at = 0; at < text.size();) {
        const std::string character = text.substr(at, length_of(text[at]));
        const bool may_break = (is_broken || is_chinese(character)) && !closes(character);
        if (may_break && !words.back().empty()) words.emplace_back();
        words.back() += character;
        is_broken = is_chinese(character) || closes(character);
        at += character.size();
    }
    return words;
}

}  // namespace scanlight::apps::window
