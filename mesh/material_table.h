#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/material.h"

namespace scanlight::mesh {

/// Materials by name, for a file that may use them before it defines them.
/// Invariant: `index_` holds each entry's place under its name.
class MaterialTable {
public:
    /// The place of the material of this name; a default one takes it until it is defined.
    std::uint32_t index_of(std::string_view name);

    /// Fills the material's place. False, and no change, if it was filled before.
    bool define(const Material& material);

    /// Names asked for and never defined, in the order of their places.
    std::vector<std::string> undefined() const;

    std::vector<Material> take() && { return std::move(materials_); }

private:
    std::vector<Material> materials_;
    std::vector<bool> defined_;
    std::map<std::string, std::uint32_t, std::less<>> index_;
};

}  // namespace scanlight::mesh
