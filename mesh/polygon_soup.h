#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/material.h"

namespace scanlight::mesh {

/// What a file says, and nothing more: points, and polygons that index them.
/// Every reader and every built-in shape returns one. Invariants, kept by the readers: all indices
/// are in range, all numbers are finite, `face_begin` ascends from 0 to `corners.size()`.
struct PolygonSoup {
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Corner {
        std::uint32_t position;
        std::uint32_t normal = none;
        std::uint32_t uv = none;
    };

    std::vector<glm::vec3> positions;  // object space
    std::vector<glm::vec3> colors;     // linear, one a position, or empty
    std::vector<glm::vec3> normals;    // as the file gives them, not always unit
    std::vector<glm::vec2> uvs;

    std::vector<Corner> corners;
    std::vector<std::uint32_t> face_begin{0};  // faces + 1 of them
    std::vector<std::uint32_t> face_material;  // one a face, or empty: all take material 0
    std::vector<Material> materials;           // may be empty
    std::vector<std::string> warnings;         // for a person: what was passed over, and why

    std::size_t face_count() const { return face_begin.size() - 1; }
    std::span<const Corner> face(std::size_t f) const {
        return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
    }
};

}  // namespace scanlight::mesh
