#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "raster/project.h"
#include "render/scene.h"

namespace scanlight::render {

/// A line in a picture, in pixels.
struct PictureLine {
    glm::dvec2 from, to;
};

/// The edges of the sides of one object's shadow volume, as far as the camera sees them were
/// nothing in the way: the ghost of the volume. `object` and `light` are places in the scene.
std::vector<PictureLine> volume_lines(const Scene& scene, const Settings& settings,
                                      std::size_t object, std::size_t light,
                                      raster::Viewport viewport);

}  // namespace scanlight::render
