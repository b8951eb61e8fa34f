#pragma once

namespace scanlight::apps {

/// The whole program: parses, runs a subcommand, reports what went wrong on standard error.
/// Returns the exit status: 0 ok, 1 a difference was found, 2 an error.
int run(int argc, const char* const* argv);

}  // namespace scanlight::apps
