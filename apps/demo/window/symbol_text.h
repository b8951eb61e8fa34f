#pragma once

#include <string>
#include <vector>

namespace scanlight::apps::window {

/// A part of a symbol, on the line or below it.
struct SymbolPiece {
    enum Place { on_line, low };
    std::string text;
    Place place = on_line;

    bool operator==(const SymbolPiece&) const = default;
};

/// "K_s'" is K, a low s and ': what follows a _ is low, as far as letters and digits go.
std::vector<SymbolPiece> pieces_of(const std::string& symbol);

/// What a line may be broken between: words with the blank after them, and each Chinese character
/// with the marks that close it.
std::vector<std::string> words_of(const std::string& text);

}  // namespace scanlight::apps::window
