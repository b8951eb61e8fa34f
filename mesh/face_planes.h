#pragma once

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// Works out of each face what textures ask of it: `face_offset`, and u and v as linear functions
/// of the point, `face_u` and `face_v`. These are exact for a flat face over which u and v are
/// linear; else their mean, by
///     grad u = 1/A sum over the edges of (u_i + u_i+1)/2 (p_i+1 - p_i) x n    (Gauss's theorem)
/// The gradients are zero for a face of no area. A mesh without uvs gets neither.
void find_face_planes(Mesh& mesh);

}  // namespace scanlight::mesh
