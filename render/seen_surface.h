#pragma once

#include "render/placed_mesh.h"
#include "render/textured.h"

namespace scanlight::render {

/// A pixel's place in its picture.
struct PixelPlace {
    int x = 0;
    int y = 0;
};

/// The surface that a face shows at a pixel that it covers, as Phong shading with textures lights
/// it. `settings` are those of its object.
TexturedSurface<float> seen_surface(const PlacedMesh& mesh, std::size_t face, const Frame& frame,
                                    const Settings& settings, const PixelPlace& pixel);

}  // namespace scanlight::render
