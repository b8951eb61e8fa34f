#pragma once

#include "apps/scene/scene_options.h"
#include "mesh/bounds.h"

namespace scanlight::apps {

/// world_from_object, by sines and cosines that have the same bits everywhere.
glm::dmat4 matrix_of(const Placement& placement);

/// The box around a mesh that is placed, in world space. That of no vertices is empty.
mesh::Box placed_box(const mesh::Mesh& mesh, const glm::dmat4& world_from_object);

}  // namespace scanlight::apps
