#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace scanlight::mesh {

inline constexpr std::size_t most_corners = 64;

/// The corners of a polygon from "X,Y:X,Y:…": 3 to 64 of them, each number from -1000 to 1000.
/// Throws FileError for another text; `what` is what its message begins with.
std::vector<glm::dvec2> parse_corners(std::string_view text, const std::string& what);

/// And back, in as few digits as tell the numbers.
std::string corners_text(std::span<const glm::dvec2> corners);

}  // namespace scanlight::mesh
