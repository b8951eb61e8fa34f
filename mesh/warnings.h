#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/cursor.h"

namespace scanlight::mesh {

/// What a reader passes over, for a person: each sentence once, with the line where it was first
/// true and how often it was; at most twenty different ones.
class Warnings {
public:
    void add(std::size_t offset, const std::string& sentence);

    /// "name:line: sentence", or "name:line: sentence, the first of 3". `text` is the file.
    std::vector<std::string> lines(const Cursor& text) const;

private:
    struct Entry {
        std::string sentence;
        std::size_t first_offset;
        std::size_t count;
    };
    std::vector<Entry> entries_;
};

}  // namespace scanlight::mesh
