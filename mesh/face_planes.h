#pragma once

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// Works out of each face what textures ask of it: `face_offset`, and how fast u and v grow over
/// it, `face_grad_u` and `face_grad_v`. These are exact for a flat face over which u and v are
/// linear; else their mean. Zero for a face of no area. A mesh without uvs gets no gradients.
///     grad u = 1/A sum over the edges of (u_i + u_i+1)/2 (p_i+1 - p_i) x n    (Gauss's theorem)
void find_face_planes(Mesh& mesh);

}  // namespace scanlight::mesh
