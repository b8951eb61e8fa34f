#pragma once

#include <string>

namespace scanlight::bench {

/// Times whole pictures and prints milliseconds a frame.
/// Throws std::runtime_error when two methods draw different pictures.
void compare_frames(int repetitions, const std::string& json_path);

}  // namespace scanlight::bench
