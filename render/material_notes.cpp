#include "render/material_notes.h"

#include <algorithm>

#include "mesh/text.h"

namespace scanlight::render {

namespace {

constexpr std::size_t most_notes = 20;

}  // namespace

void MaterialNotes::add(const mesh::Material& material, const std::string& sentence) {
    const auto known = std::ranges::find(notes_, sentence, &Note::sentence);
    if (known != notes_.end()) {
        ++known->count;
    } else if (notes_.size() < most_notes) {
        notes_.push_back({sentence, material.name, 1});
    }
}

std::vector<std::string> MaterialNotes::lines() const {
    std::vector<std::string> lines;
    for (const Note& note : notes_) {
        const std::string more =
            note.count > 1 ? " and " + std::to_string(note.count - 1) + " more" : "";
        lines.push_back("material " + mesh::quoted(note.material) + more + ": " + note.sentence);
    }
    return lines;
}

}  // namespace scanlight::render
