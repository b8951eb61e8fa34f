#include "apps/scene/toml_number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace scanlight::apps {

namespace {

template <class Number>
std::string shortest(Number number) {
    std::array<char, 64> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

double read_back(const std::string& text) {
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

std::string escaped(char c) {
    constexpr char digits[] = "0123456789abcdef";
    if (c == '"' || c == '\\') return {'\\', c};
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte != 0x7f) return {c};
    return {'\\', 'u', '0', '0', digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

std::string toml_number(double number) {
    return shortest(number);
}

std::string toml_number(float number) {
    const std::string text = shortest(number);
    // A file's number is a double first; rounded twice it may be another float.
    return static_cast<float>(read_back(text)) == number ? text
                                                         : toml_number(static_cast<double>(number));
}

std::string toml_string(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text)
        quoted += escaped(c);
    return quoted + "\"";
}

}  // namespace scanlight::apps
