#pragma once

#include <glm/vec2.hpp>

#include "render/placed_mesh.h"
#include "render/textured.h"

namespace scanlight::render {

/// The surface that a face shows at a pixel that it covers, as Phong shading with textures lights
/// it. `settings` are those of its object.
TexturedSurface<float> seen_surface(const PlacedMesh& mesh, std::size_t face, const Frame& frame,
                                    const Settings& settings, const glm::ivec2& pixel);

}  // namespace scanlight::render
