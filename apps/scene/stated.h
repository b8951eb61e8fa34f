#pragma once

#include <string>

namespace scanlight::apps {

/// "scene.toml:12:3: ", where something is stated in a scene file; empty where it is not.
std::string prefix_of(const std::string& stated_at);

/// Throws UsageError unless a file that a scene file names is a regular one, for a pipe can wait
/// for ever. What a command line names is not looked at. `what` is "mesh".
void expect_file(const std::string& stated_at, const std::string& what, const std::string& path);

}  // namespace scanlight::apps
