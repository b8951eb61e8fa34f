#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace scanlight::peers {

/// Triangles as OpenGL takes them. Each vertex is a row of numbers, three an attribute.
struct GlGeometry {
    int attributes;  // 2: position, normal; 3: and the middle of the polygon, or (u, v, 0)
    std::vector<float> numbers;  // 3 attributes for each vertex
    std::vector<std::uint32_t> corners;
};

/// Vertices and their normals as the mesh has them; polygons (convex) are cut into triangles.
GlGeometry smooth_geometry(const mesh::Mesh& mesh);

/// The same with (u, v). Requires a mesh that has them.
GlGeometry mapped_geometry(const mesh::Mesh& mesh);

/// For flat shading: the last corner of each triangle carries its polygon's normal and the mean of
/// its corners. A polygon takes over one of its vertices for that and a new vertex is made only
/// when all of them are taken: that is as few as can be.
GlGeometry flat_geometry(const mesh::Mesh& mesh);

}  // namespace scanlight::peers
