#pragma once

#include <string>

#include "tests/raster/temporary_folder.h"

namespace scanlight::apps {

using raster::contents_of;
using raster::put;

/// How a command ended.
struct Outcome {
    int status = -1;  // exit status; 128 and more: killed by a signal
    std::string out;
    std::string err;
};

/// A folder of its own in which command lines run, as a person types them. `scanlight` is the
/// program that was built with these tests.
class Shell {
public:
    Shell();

    Outcome run(const std::string& command_line) const;

    /// The path of a file in the folder.
    std::string operator/(const std::string& name) const { return folder_ / name; }
    bool has(const std::string& name) const;
    std::size_t file_count() const { return folder_.file_count(); }

    /// A small file of the folder, binary or text.
    std::string read(const std::string& name) const { return contents_of(folder_ / name); }
    void write(const std::string& name, const std::string& text) const {
        put(folder_ / name, text);
    }

private:
    raster::TemporaryFolder folder_;
    raster::TemporaryFolder streams_;  // what the command prints, out of its sight
};

/// "scanlight: " and one line.
bool is_one_complaint(const std::string& err);

}  // namespace scanlight::apps
