#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace scanlight::demo {

inline constexpr int exit_ok = 0;
inline constexpr int exit_error = 2;

/// Parses the command line and does what it asks for: `act` returns the exit status. --help is
/// printed, and what goes wrong told on standard error, where the exit status is `exit_error`.
int parse_and_act(CLI::App& program, int argc, const char* const* argv,
                  const std::function<int()>& act);

}  // namespace scanlight::demo
