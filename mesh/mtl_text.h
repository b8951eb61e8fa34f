#pragma once

#include <span>
#include <string>

#include "mesh/material.h"

namespace scanlight::mesh {

/// The materials as a Wavefront MTL file that `load_mtl` reads back the same: every number, and of
/// each map what is not usual. Materials without a name, which MTL cannot express, are left out.
std::string mtl_text(std::span<const Material> materials);

}  // namespace scanlight::mesh
