#pragma once

namespace scanlight::demo {

/// The course without a window: parses, draws or exports, reports what went wrong on standard
/// error. Returns the exit status: 0 ok, 2 an error.
int run(int argc, const char* const* argv);

}  // namespace scanlight::demo
