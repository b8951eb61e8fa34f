#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scanlight::mesh {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
constexpr bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
constexpr bool is_space(char c) {
    return is_blank(c) || is_line_end(c);
}
constexpr char lower(char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Whether two words differ in nothing but ASCII case.
bool equal_ignoring_case(std::string_view a, std::string_view b);

std::string_view trimmed(std::string_view text);

/// The pieces between separators, one at least.
std::vector<std::string_view> split(std::string_view text, char separator);

/// File text made fit for a message: in quotes, cut after 60 characters, nothing unprintable.
std::string quoted(std::string_view text);

/// The same without the quotes.
std::string printable(std::string_view text);

/// "1 vertex", "3 vertices".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// How many letters must be added, left out or changed. Levenshtein 1966.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace scanlight::mesh
