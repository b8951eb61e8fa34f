#include "apps/scanlight/text_table.h"

#include <algorithm>
#include <cstdio>

namespace scanlight::apps {

namespace {

/// Characters, not bytes.
std::size_t width_of(const std::string& word) {
    return static_cast<std::size_t>(
        std::count_if(word.begin(), word.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string blanks_beside(const std::string& word, std::size_t width) {
    const std::size_t own = width_of(word);
    return std::string(width > own ? width - own : 0, ' ');
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

}  // namespace

TextTable::TextTable(std::vector<std::string> header) {
    rows_.push_back(std::move(header));
}

void TextTable::add_row(std::vector<std::string> row) {
    rows_.push_back(std::move(row));
}

std::string TextTable::text(const std::string& indent) const {
    std::vector<std::size_t> widths(rows_.front().size(), 0);
    for (const auto& row : rows_) {
        for (std::size_t k = 0; k < row.size() && k < widths.size(); ++k) {
            widths[k] = std::max(widths[k], width_of(row[k]));
        }
    }
    std::string result;
    for (const auto& row : rows_) {
        std::string line = indent;
        for (std::size_t k = 0; k < row.size() && k < widths.size(); ++k) {
            const std::string blanks = blanks_beside(row[k], widths[k]);
            line += k == 0 ? "" : "  ";
            line += left_.contains(k) ? row[k] + blanks : blanks + row[k];
        }
        result += without_trailing_blanks(line) + "\n";
    }
    return result;
}

std::string fixed(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    const std::string result = text;
    const bool is_zero = result.find_first_not_of("-0.") == std::string::npos;
    return is_zero && result.front() == '-' ? result.substr(1) : result;
}

}  // namespace scanlight::apps
