#include "mesh/warnings.h"

namespace scanlight::mesh {

std::vector<std::string> Warnings::lines(const Cursor& text) const {
    std::vector<std::string> lines;
    for (const auto& [sentence, offset, count] : sentences_) {
        lines.push_back(text.where(offset) + ": " + sentence);
        if (count > 1) lines.back() += ", the first of " + std::to_string(count);
    }
    return lines;
}

}  // namespace scanlight::mesh
