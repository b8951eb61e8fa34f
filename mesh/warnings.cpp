#include "mesh/warnings.h"

#include <algorithm>

namespace scanlight::mesh {
namespace {

constexpr std::size_t most_sentences = 20;

}  // namespace

void Warnings::add(std::size_t offset, const std::string& sentence) {
    const auto known = std::ranges::find(entries_, sentence, &Entry::sentence);
    if (known != entries_.end()) {
        ++known->count;
    } else if (entries_.size() < most_sentences) {
        entries_.push_back({sentence, offset, 1});
    }
}

std::vector<std::string> Warnings::lines(const Cursor& text) const {
    std::vector<std::string> lines;
    for (const Entry& entry : entries_) {
        lines.push_back(text.where(entry.first_offset) + ": " + entry.sentence);
        if (entry.count > 1) lines.back() += ", the first of " + std::to_string(entry.count);
    }
    return lines;
}

}  // namespace scanlight::mesh
