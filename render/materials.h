#pragma once

#include <string_view>
#include <vector>

#include "mesh/material.h"
#include "shading/material.h"

namespace scanlight::render {

/// What a mesh file's material means to the illumination models: K_a = Ka, K_d = Kd, K_s = Ks,
/// n = Ns, the light of its own Ke, the filter Tf, and the opacity d, within 0 to 1. `illum` 0 is
/// the colour Kd whatever the light, 1 has no highlight; for the others see `approximation_of`. 3
/// to 9, and whatever has a reflection map, mirror surroundings, K_s' = Ks. Facets have the index
/// Ni, where it is more than 1.
shading::Material<float> shading_material(const mesh::Material& material);

std::vector<shading::Material<float>> shading_materials(
    const std::vector<mesh::Material>& materials);

/// What is not as an `illum` asks for. Empty for 0, 1 and 2, which are drawn in full.
std::string_view approximation_of(int illum);

}  // namespace scanlight::render
