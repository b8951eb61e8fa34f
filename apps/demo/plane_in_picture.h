#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "raster/project.h"
#include "render/camera.h"

namespace scanlight::demo {

/// From x and y of the plane z = 0 to pixels of a picture of this size; homogeneous.
glm::dmat3 picture_from_plane(const render::Camera& camera, raster::Viewport size);

/// A point by a homogeneous matrix.
glm::dvec2 mapped(const glm::dmat3& matrix, const glm::dvec2& point);

}  // namespace scanlight::demo
