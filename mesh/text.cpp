#include "mesh/text.h"

#include <algorithm>

namespace scanlight::mesh {

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    const auto printable = [](char c) { return c < ' ' || c > '~' ? '?' : c; };
    std::string result = "\"";
    for (const char c : text.substr(0, longest))
        result += printable(c);
    return result + (text.size() > longest ? "...\"" : "\"");
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace scanlight::mesh
