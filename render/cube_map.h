#pragma once

#include <glm/vec3.hpp>

#include "render/scene.h"

namespace scanlight::render {

/// What is seen from a point, world space, on the six faces of a cube (Greene 1986, see
/// shading/environment.h), each of `side` x `side` pixels: an environment for what stands there.
/// What shows an environment itself is left out. Drawn by the fast path.
shading::Environment cube_map(const Scene& scene, Settings settings, const glm::dvec3& point,
                              int side);

}  // namespace scanlight::render
