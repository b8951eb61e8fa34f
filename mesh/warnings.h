#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/cursor.h"
#include "mesh/sentences.h"

namespace scanlight::mesh {

/// What a reader passes over, by its offset in the file.
class Warnings {
public:
    void add(std::size_t offset, const std::string& sentence) { sentences_.add(offset, sentence); }

    /// "name:line: sentence", or "name:line: sentence, the first of 3". `text` is the file.
    std::vector<std::string> lines(const Cursor& text) const;

private:
    Sentences<std::size_t> sentences_;
};

}  // namespace scanlight::mesh
