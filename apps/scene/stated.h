#pragma once

#include <initializer_list>
#include <map>
#include <string>

namespace scanlight::apps {

/// Where a table of a scene file and the values of its keys stand, as "scene.toml:12:3", for
/// messages; empty of what no file states.
struct Stated {
    std::string table;
    std::map<std::string, std::string> values;  // by their keys

    /// The value of the first of these keys that is given; else the table.
    const std::string& at(std::initializer_list<std::string> keys) const;
};

/// "scene.toml:12:3: ", where something is stated in a scene file; empty where it is not.
std::string prefix_of(const std::string& stated_at);

/// Throws UsageError unless a file that a scene file names is a regular one, for a pipe can wait
/// for ever. What a command line names is not looked at. `what` is "mesh".
void expect_file(const std::string& stated_at, const std::string& what, const std::string& path);

}  // namespace scanlight::apps
