#pragma once

#include <vector>

#include "mesh/material.h"
#include "shading/material.h"

namespace scanlight::render {

/// What a mesh file's material means to the illumination models: K_a = Ka, K_d = Kd, K_s = Ks,
/// n = Ns; `illum` 0 and 1 have no highlight. Facets have the index Ni, where it is more than 1.
shading::Material<float> shading_material(const mesh::Material& material);

std::vector<shading::Material<float>> shading_materials(
    const std::vector<mesh::Material>& materials);

}  // namespace scanlight::render
