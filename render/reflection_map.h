#pragma once

#include <memory>
#include <vector>

#include "mesh/material.h"
#include "render/material_notes.h"
#include "render/texture_loader.h"
#include "shading/environment.h"

namespace scanlight::render {

// What an MTL material mirrors by its statement refl: of -type sphere a picture by latitudes, y up;
// of -type cube_right, cube_left, cube_top, cube_bottom, cube_front and cube_back the six sides of
// a cube (+x -x +y -y -z +z), each upright. Of both, the cube.

/// Whether the material mirrors anything of its own.
bool has_reflection_map(const mesh::Material& material);

/// The pictures of it. None where sides of a cube are missing.
std::vector<WantedTexture> sides_wanted(const mesh::Material& material);

/// The environment of these pictures; none, with a note where it is asked for, where one is not
/// among those loaded.
std::shared_ptr<const shading::Environment> own_surroundings(const mesh::Material& material,
                                                             const LoadedTextures& all,
                                                             MaterialNotes& notes);

}  // namespace scanlight::render
