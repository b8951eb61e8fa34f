#pragma once

#include <string>

namespace scanlight::bench {

/// Times single triangles by the mean length of their spans and prints nanoseconds a pixel.
/// Throws std::runtime_error when two methods draw different pictures.
void compare_interpolations(int repetitions, const std::string& json_path);

}  // namespace scanlight::bench
