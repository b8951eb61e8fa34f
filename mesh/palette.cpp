#include "mesh/palette.h"

#include <bit>
#include <utility>

#include "mesh/text.h"

namespace scanlight::mesh {
namespace {

/// The default material, dyed: its ambient part keeps its proportion to the diffuse one.
Material dyed(const glm::vec3& color, std::size_t number) {
    const Material plain;
    Material material;
    material.name = "face color " + std::to_string(number);
    material.diffuse = color;
    material.ambient = color * (plain.ambient / plain.diffuse);
    return material;
}

}  // namespace

std::uint32_t Palette::index_of(const glm::vec3& color) {
    const Bits bits{std::bit_cast<std::uint32_t>(color.x), std::bit_cast<std::uint32_t>(color.y),
                    std::bit_cast<std::uint32_t>(color.z)};
    const auto known = index_.find(bits);
    if (known != index_.end()) return known->second;
    if (index_.size() == max_colors) {
        ++refused_;
        return 0;
    }
    const auto index = static_cast<std::uint32_t>(materials_.size());
    materials_.push_back(dyed(color, index));
    return index_[bits] = index;
}

void Palette::give_to(PolygonSoup& soup) && {
    if (refused_ > 0) {
        soup.warnings.push_back("more than " + std::to_string(max_colors) +
                                " face colors: " + counted(refused_, "face takes", "faces take") +
                                " the default material");
    }
    if (index_.empty()) {
        soup.face_material.clear();
    } else {
        soup.materials = std::move(materials_);
    }
}

}  // namespace scanlight::mesh
