#pragma once

#include <cstddef>

#include "render/draw.h"

namespace scanlight::render {

/// The same scene in other light.
Scene lit_by(Scene scene, shading::Lighting<float> lighting);
/// In one of its lights, and no other light at all: neither ambient nor from its surroundings.
Scene lit_by_one(const Scene& scene, std::size_t light);

/// Draws a scene with shadows, in many passes as in the literature: the ambient light first, then
/// each light alone, where it reaches (see `lit_share`).
/// A pixel in the shadow of all lights has the colour of the ambient picture, to the bit.
Drawing draw_with_shadows(const Scene& scene, const Settings& settings, raster::Viewport viewport);

}  // namespace scanlight::render
