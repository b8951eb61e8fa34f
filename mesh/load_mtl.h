#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/material.h"

namespace scanlight::mesh {

/// What a material library says.
struct MaterialLibrary {
    std::vector<Material> materials;    // in the file's order; names may repeat
    std::vector<std::string> warnings;  // "name:line: what, and what is done about it"
};

/// Reads a Wavefront MTL file: Ka Kd Ks Ke Tf Ns Ni d Tr illum of each newmtl, and its maps: map_Ka
/// map_Kd map_Ks map_Ke map_Ns map_d bump norm refl. The rest is passed over with a warning. The
/// latest of two statements for one thing holds. `name` is for messages. Throws FileError
/// "name:line: reason".
MaterialLibrary load_mtl(std::string_view bytes, const std::string& name);

}  // namespace scanlight::mesh
