#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/material.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// The colours of a file's faces, as materials: one a distinct colour, by first appearance.
/// Invariant: material 0 is the default, for faces without a colour and for those past the bound.
class Palette {
public:
    static constexpr std::size_t max_colors = 1 << 16;

    /// The material of faces of this linear colour.
    std::uint32_t index_of(const glm::vec3& color);

    /// Hands the materials over; a soup whose faces have no colour stays without.
    void give_to(PolygonSoup& soup) &&;

private:
    using Bits = std::array<std::uint32_t, 3>;

    std::vector<Material> materials_{Material{}};
    std::map<Bits, std::uint32_t> index_;
    std::size_t refused_ = 0;
};

}  // namespace scanlight::mesh
