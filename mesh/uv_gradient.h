#pragma once

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// Works out how fast u and v grow over each face: `face_grad_u` and `face_grad_v`. Exact for a
/// flat face over which they are linear; else their mean. Zero for a face of no area. A mesh
/// without uvs gets none.
///     grad u = 1/A sum over the edges of (u_i + u_i+1)/2 (p_i+1 - p_i) x n    (Gauss's theorem)
void find_uv_gradients(Mesh& mesh);

}  // namespace scanlight::mesh
