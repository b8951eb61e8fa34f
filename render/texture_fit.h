#pragma once

#include "mesh/bounds.h"
#include "shading/texture.h"

namespace scanlight::render {

/// Which axis of the object is the texture's z: that of cylinders, spheres and trunks, and the one
/// that a planar mapping looks along.
enum class Axis { x, y, z };

/// Lays a texture's auxiliary surface about a box in object space: a plane across it, whose (u, v)
/// run from 0 to 1; a cylinder around it, v from its one end to the other; a sphere about its
/// middle. Space textures have the middle at 0 and the longest side from -scale to scale. The
/// others are scaled on top of that. The mesh's own (u, v) stay.
shading::Texture fitted(shading::Texture texture, const mesh::Box& box, Axis axis, double scale);

}  // namespace scanlight::render
