#pragma once

#include <string>
#include <vector>

#include "mesh/material.h"
#include "mesh/sentences.h"

namespace scanlight::render {

/// What is drawn otherwise than a file's materials ask, by the materials' names.
class MaterialNotes {
public:
    void add(const mesh::Material& material, const std::string& sentence) {
        sentences_.add(material.name, sentence);
    }

    /// `material "oak": sentence`, or `material "oak" and 3 more: sentence`.
    std::vector<std::string> lines() const;

private:
    mesh::Sentences<std::string> sentences_;
};

}  // namespace scanlight::render
