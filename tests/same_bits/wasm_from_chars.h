#pragma once

// Emscripten 3.1.69 reads no floating point by `from_chars`. Whoever reads no files needs to know
// no more than that there is such a function.

#include <charconv>

namespace std {

from_chars_result from_chars(const char*, const char*, float&,
                             chars_format = chars_format::general);
from_chars_result from_chars(const char*, const char*, double&,
                             chars_format = chars_format::general);

}  // namespace std
