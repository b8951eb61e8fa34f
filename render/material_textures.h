#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/material.h"
#include "render/texture_loader.h"
#include "shading/surface_textures.h"

namespace scanlight::render {

/// What all textures of a mesh together may take, with their pyramids.
inline constexpr std::size_t most_texture_bytes = std::size_t{1} << 31;

/// The textures of a mesh's materials, and for a person what of them is not drawn, and why.
struct MaterialTextures {
    std::vector<shading::SurfaceTextures> textures;  // one a material; empty if there is none
    std::vector<std::string> warnings;
};

/// The maps that the materials name: map_Kd as diffuse texture and so on. -s and -o repeat and
/// shift it, -clamp on repeats its outermost texels, -mm is what 0 and 1 stand for (low = base,
/// high = base + gain), -blendu and -blendv off, together, take the nearest texel. A bump map's
/// white is `bump_unit` times -bm high, in world units; -bm scales the slopes of a normal map. For
/// numbers (map_Ns, map_d, bump) -imfchan picks a channel; without it they take the luminance, but
/// map_d the alpha of a picture that has one. refl becomes what the material mirrors.
/// Each file is loaded once. One that cannot be used is a warning, and the surface is drawn without
/// it; so is one that would take the textures past `most_bytes`, in the order of their names.
MaterialTextures surface_textures(const std::vector<mesh::Material>& materials,
                                  const LoadImage& load, double bump_unit,
                                  std::size_t most_bytes = most_texture_bytes);

/// What of the materials' illumination models is not drawn.
std::vector<std::string> approximations(const std::vector<mesh::Material>& materials);

}  // namespace scanlight::render
