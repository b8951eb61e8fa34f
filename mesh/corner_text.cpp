#include "mesh/corner_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "mesh/file_error.h"
#include "mesh/text.h"

namespace scanlight::mesh {
namespace {

constexpr double farthest = 1000.0;

std::optional<double> coordinate(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    return whole && std::abs(value) <= farthest ? std::optional(value) : std::nullopt;  // no NaN
}

glm::dvec2 corner(std::string_view text, const std::string& what) {
    const auto parts = split(text, ',');
    const auto x = coordinate(parts.front());
    const auto y = coordinate(parts.back());
    if (parts.size() == 2 && x && y) return {*x, *y};
    throw FileError(what + ": " + quoted(text) +
                    " is no corner X,Y of two numbers from -1000 to 1000");
}

std::string coordinate_text(double value) {
    std::array<char, 32> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

}  // namespace

std::vector<glm::dvec2> parse_corners(std::string_view text, const std::string& what) {
    const auto pieces = split(text, ':');
    if (pieces.size() < 3 || pieces.size() > most_corners) {
        throw FileError(what + ": " + counted(pieces.size(), "corner", "corners") +
                        ", expected 3 to " + std::to_string(most_corners) + " as X,Y:X,Y:X,Y");
    }
    std::vector<glm::dvec2> corners;
    for (const std::string_view piece : pieces)
        corners.push_back(corner(piece, what));
    return corners;
}

std::string corners_text(std::span<const glm::dvec2> corners) {
    std::string text;
    for (const glm::dvec2& corner : corners) {
        text +=
            (text.empty() ? "" : ":") + coordinate_text(corner.x) + "," + coordinate_text(corner.y);
    }
    return text;
}

}  // namespace scanlight::mesh
