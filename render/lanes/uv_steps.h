#pragma once

#include <cstddef>

#include "render/lanes/pixel_lanes.h"
#include "render/textured.h"

namespace scanlight::render::HWY_NAMESPACE {

// How (u, v) go on from pixel to pixel over a face: worked out once a face and picture where faces
// have many pixels, else as often as they are asked for. The same bits.

/// Vectors that lie one after another in memory.
inline glm::vec<4, Floats> gather(const std::vector<glm::vec4>& vectors, Ints index) {
    const float* base = &vectors.data()->x;
    const Ints first = index * Ints(4);
    return {gather(base, first), gather(base, first + Ints(1)), gather(base, first + Ints(2)),
            gather(base, first + Ints(3))};
}

/// A lane is a face.
inline FaceUvSteps<Floats> worked_out_uv_steps(const ObjectPass& pass, Ints face) {
    const mesh::Mesh& mesh = pass.mesh();
    return face_uv_steps(pass.face_matrices.object_from_screen, gather(mesh.face_normals, face),
                         gather(mesh.face_offset.data(), face), gather(mesh.face_u, face),
                         gather(mesh.face_v, face));
}

/// Faces [begin, end) of a pass that keeps them.
SCANLIGHT_FLATTEN inline void find_face_uv_steps(ObjectPass& pass, std::size_t begin,
                                                 std::size_t end) {
    const Ints last(static_cast<std::int32_t>(end) - 1);
    for (std::size_t i = begin; i < end; i += lane_count) {
        const Ints face = min(Ints(static_cast<std::int32_t>(i)) + iota(), last);
        const auto [right, down] = worked_out_uv_steps(pass, face);
        const Floats steps[] = {right.x, right.y, right.z, down.x, down.y, down.z};
        float lanes[6][lane_count];
        for (int k = 0; k < 6; ++k)
            store(steps[k], lanes[k]);
        for (std::size_t j = 0; j < std::min<std::size_t>(lane_count, end - i); ++j) {
            pass.face_uv_steps[i + j] = {{lanes[0][j], lanes[1][j], lanes[2][j]},
                                         {lanes[3][j], lanes[4][j], lanes[5][j]}};
        }
    }
}

/// Some numbers of each pixel's face, out of one row of `stride` numbers a face. Where all show one
/// face its numbers are fetched once. To do the same for each of a few faces takes more time than
/// gathering, for their count cannot be foretold.
template <int count>
void fetch_rows(const float* rows, int stride, Ints face, Floats* to) {
    const std::int32_t first = first_lane(face);
    if (all(face == Ints(first))) {
        for (int k = 0; k < count; ++k)
            to[k] = Floats(rows[std::ptrdiff_t{first} * stride + k]);
        return;
    }
    const Ints row = face * Ints(stride);
    for (int k = 0; k < count; ++k)
        to[k] = gather(rows + k, row);
}

/// Of the pixels' faces.
inline FaceUvSteps<Floats> face_uv_steps(const ObjectPass& pass, Ints face) {
    if (pass.face_uv_steps.empty()) return worked_out_uv_steps(pass, face);
    Floats n[6];
    fetch_rows<6>(&pass.face_uv_steps.data()->right.x, 6, face, n);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

/// Of a function over the pixels' faces, object space.
inline VectorLanes face_gradient(const std::vector<glm::vec4>& functions, Ints face) {
    Floats n[3];
    fetch_rows<3>(&functions.data()->x, 4, face, n);
    return {n[0], n[1], n[2]};
}

}  // namespace scanlight::render::HWY_NAMESPACE
