#pragma once

namespace scanlight::demo {

#ifdef SCANLIGHT_WINDOW
inline constexpr bool has_window = true;
#else
inline constexpr bool has_window = false;
#endif

/// The live window, by the options of `scanlight render` and some of its own; returns the exit
/// status when it is closed. Only where there is one.
int run_window_program(int argc, const char* const* argv);

}  // namespace scanlight::demo
