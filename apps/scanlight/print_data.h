#pragma once

#include <string>

namespace scanlight::apps {

/// Data for a person or a program: to standard output, and every byte of it or ImageError. A
/// picture that goes there (`picture` is "-") keeps it to itself: then to standard error.
void print_data(const std::string& text, const std::string& picture = "");

}  // namespace scanlight::apps
