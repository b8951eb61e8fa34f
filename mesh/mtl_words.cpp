#include "mesh/mtl_words.h"

namespace scanlight::mesh {

std::string statement_for(MapUse use) {
    const std::string_view side = word_for(reflection_types, use);
    if (!side.empty()) return "refl -type " + std::string(side);
    return std::string(word_for(map_statements, use));
}

}  // namespace scanlight::mesh
