#pragma once

#include <cstdint>
#include <span>

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// The mesh with these faces only, in this order. All vertices and materials stay, and with them
/// their numbers.
Mesh part(const Mesh& mesh, std::span<const std::uint32_t> faces);

}  // namespace scanlight::mesh
