#include "render/material_notes.h"

#include "mesh/text.h"

namespace scanlight::render {

std::vector<std::string> MaterialNotes::lines() const {
    std::vector<std::string> lines;
    for (const auto& [sentence, material, count] : sentences_) {
        const std::string more = count > 1 ? " and " + std::to_string(count - 1) + " more" : "";
        lines.push_back("material " + mesh::quoted(material) + more + ": " + sentence);
    }
    return lines;
}

}  // namespace scanlight::render
