#pragma once

#include <algorithm>
#include <cstddef>

#include "render/lanes/pixel_lanes.h"
#include "render/lanes/store.h"
#include "render/textured.h"

namespace scanlight::render::HWY_NAMESPACE {

// (u, v) over the faces: worked out once a face and picture where faces have many pixels, else as
// often as they are asked for. The same bits.

/// Vectors that lie one after another in memory.
inline glm::vec<4, Floats> gather(const std::vector<glm::vec4>& vectors, Ints index) {
    const float* base = &vectors.data()->x;
    const Ints first = index * Ints(4);
    return {gather(base, first), gather(base, first + Ints(1)), gather(base, first + Ints(2)),
            gather(base, first + Ints(3))};
}

/// A lane is a face. Zero where the mesh has no (u, v).
inline FaceUvs<Floats> worked_out_uvs(const ObjectPass& pass, Ints face) {
    const mesh::Mesh& mesh = pass.mesh();
    const VectorLanes zero(Floats(0));
    if (mesh.face_u.empty()) return {{zero, zero}, {zero, zero}};
    return face_uvs(pass.face_matrices, gather(mesh.face_normals, face),
                    gather(mesh.face_offset.data(), face), gather(mesh.face_u, face),
                    gather(mesh.face_v, face));
}

/// Of a vector of faces, a row each: 12 numbers.
struct FaceRows {
    static constexpr int size = 12;  // numbers

    explicit FaceRows(const FaceUvs<Floats>& uvs) {
        const auto& [steps, gradients] = uvs;
        const VectorLanes* const vectors[] = {&steps.right, &steps.down, &gradients.u,
                                              &gradients.v};
        for (int k = 0; k < size; ++k)
            store((*vectors[k / 3])[k % 3], lanes_[k]);
    }
    FaceUvs<float> operator[](std::size_t lane) const {
        const auto vector = [&](int k) {
            return glm::vec3(lanes_[k][lane], lanes_[k + 1][lane], lanes_[k + 2][lane]);
        };
        return {{vector(0), vector(3)}, {vector(6), vector(9)}};
    }

private:
    float lanes_[size][lane_count];
};

/// See `MagnifiedFaces`: 1 or 0.
inline Ints find_magnified(const ObjectPass& pass, Ints face,
                           const shading::PixelSteps<VectorLanes>& steps) {
    const mesh::Vertices& v = pass.mesh().vertices;
    MagnifiedFaces<Floats> faces(steps, pass.needs.texels,
                                 uv_precision(pass.uv_unit, pass.frame->viewport));
    for_each_corner(pass.mesh(), face, [&](Ints vertex, Mask has) {
        faces.add(has, {gather(v.u.data(), vertex), gather(v.v.data(), vertex)},
                  gather(pass.vertices.w.data(), vertex));
    });
    const float near = 1.0f / pass.frame->world_from_screen[3][3];
    return select(faces.are_sure(near), Ints(1), Ints(0));
}

/// Faces [begin, end) of a pass that keeps them.
SCANLIGHT_FLATTEN inline void find_face_uvs(ObjectPass& pass, std::size_t begin, std::size_t end) {
    const Ints last(static_cast<std::int32_t>(end) - 1);
    for (std::size_t i = begin; i < end; i += lane_count) {
        const Ints face = min(Ints(static_cast<std::int32_t>(i)) + iota(), last);
        const std::size_t count = std::min<std::size_t>(lane_count, end - i);
        const FaceUvs<Floats> uvs = worked_out_uvs(pass, face);
        const FaceRows rows(uvs);
        for (std::size_t j = 0; j < count; ++j)
            pass.face_uvs[i + j] = rows[j];
        if (pass.is_magnified.empty()) continue;
        store_some(find_magnified(pass, face, uvs.steps), static_cast<int>(count),
                   pass.is_magnified.data() + i);
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

// Of the pixels' faces.

/// Whether all are known to be so.
inline bool are_magnified(const ObjectPass& pass, Ints face) {
    if (pass.is_magnified.empty()) return false;
    const std::int32_t first = first_lane(face);
    if (all(face == Ints(first))) return pass.is_magnified[static_cast<std::size_t>(first)] != 0;
    return all(gather(pass.is_magnified.data(), face) == Ints(1));
}

inline shading::PixelSteps<VectorLanes> face_uv_steps(const ObjectPass& pass, Ints face) {
    if (pass.face_uvs.empty()) return worked_out_uvs(pass, face).steps;
    Floats n[6];
    fetch_rows<6>(&pass.face_uvs.data()->steps.right.x, FaceRows::size, face, n);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

inline shading::UvGradients<Floats> face_gradients(const ObjectPass& pass, Ints face) {
    if (pass.face_uvs.empty()) return worked_out_uvs(pass, face).gradients;
    Floats n[6];
    fetch_rows<6>(&pass.face_uvs.data()->gradients.u.x, FaceRows::size, face, n);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

}  // namespace scanlight::render::HWY_NAMESPACE
