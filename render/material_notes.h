#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/material.h"

namespace scanlight::render {

/// What is drawn otherwise than a file's materials ask, for a person: each sentence once, with the
/// first material of which it is true; at most twenty different ones.
class MaterialNotes {
public:
    void add(const mesh::Material& material, const std::string& sentence);

    /// `material "oak": sentence`, or `material "oak" and 3 more: sentence`.
    std::vector<std::string> lines() const;

private:
    struct Note {
        std::string sentence;
        std::string material;
        std::size_t count;
    };
    std::vector<Note> notes_;
};

}  // namespace scanlight::render
