#include "mesh/material_table.h"

namespace scanlight::mesh {

std::uint32_t MaterialTable::index_of(std::string_view name) {
    const auto known = index_.find(name);
    if (known != index_.end()) return known->second;
    const auto index = static_cast<std::uint32_t>(materials_.size());
    materials_.push_back({.name = std::string(name)});
    defined_.push_back(false);
    index_.emplace(name, index);
    return index;
}

bool MaterialTable::define(const Material& material) {
    const std::uint32_t index = index_of(material.name);
    if (defined_[index]) return false;
    materials_[index] = material;
    defined_[index] = true;
    return true;
}

std::vector<std::string> MaterialTable::undefined() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        if (!defined_[i]) names.push_back(materials_[i].name);
    }
    return names;
}

}  // namespace scanlight::mesh
