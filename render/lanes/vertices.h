#pragma once

#include "mesh/mesh.h"
#include "raster/clip.h"
#include "raster/lanes/numbers.h"
#include "raster/polygon_streams.h"
#include "render/transform.h"
#include "render/vertex_streams.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;
using VectorLanes = shading::Vec3<Floats>;

/// The scalar code's steps from object space to the screen (`transformed_point`, `snapped`), for as
/// many vertices as there are lanes.
class VertexPlacer {
public:
    VertexPlacer(const Placing& placing, raster::Viewport viewport, VertexStreams& out)
        : placing_(placing), viewport_(viewport), out_(out) {}

    /// Vertices [begin, end). The clip planes beyond which any of them lies.
    SCANLIGHT_FLATTEN std::int32_t place(const mesh::Vertices& vertices, std::size_t begin,
                                         std::size_t end) const {
        Ints outside(0);
        for (std::size_t i = begin; i < end; i += lane_count) {
            const int n = static_cast<int>(std::min<std::size_t>(lane_count, end - i));
            place_position(vector_at(vertices.x, vertices.y, vertices.z, i, n), i);
            outside = outside | select(first_lanes(n), load(out_.outside.data() + i), Ints(0));
            if (!out_.normals.x.empty()) {
                const VectorLanes normal = vector_at(vertices.nx, vertices.ny, vertices.nz, i, n);
                write(transformed_normal(placing_.normals_from_object, normal), out_.normals, i);
            }
        }
        return joined_bits(outside);
    }

private:
    /// Nothing is read behind the last element.
    static Floats some(const std::vector<float>& stream, std::size_t i, int n) {
        if (n == lane_count) return load(stream.data() + i);
        float values[lane_count] = {};
        std::copy_n(stream.data() + i, n, values);
        return load(values);
    }
    static VectorLanes vector_at(const std::vector<float>& x, const std::vector<float>& y,
                                 const std::vector<float>& z, std::size_t i, int n) {
        return {some(x, i, n), some(y, i, n), some(z, i, n)};
    }
    static void write(const VectorLanes& v, VectorStreams& to, std::size_t i) {
        store(v.x, to.x.data() + i);
        store(v.y, to.y.data() + i);
        store(v.z, to.z.data() + i);
    }

    void place_position(const VectorLanes& object, std::size_t i) const {
        const shading::Vec3<Doubles> position(doubles_of(object.x), doubles_of(object.y),
                                              doubles_of(object.z));
        const auto clip = transformed_point(placing_.clip_from_object, position);
        snap(floats_of(clip.x), floats_of(clip.y), floats_of(clip.z), floats_of(clip.w), i);
        if (out_.points.x.empty()) return;
        const glm::dmat4& m = placing_.world_from_object;
        write(
            {floats_of(point_component(m, 0, position)), floats_of(point_component(m, 1, position)),
             floats_of(point_component(m, 2, position))},
            out_.points, i);
    }

    void snap(Floats x, Floats y, Floats z, Floats w, std::size_t i) const {
        const Floats half_width(0.5f * static_cast<float>(viewport_.width));
        const Floats half_height(0.5f * static_cast<float>(viewport_.height));
        store(snapped((x / w + Floats(1)) * half_width, viewport_.width), out_.x.data() + i);
        store(snapped((Floats(1) - y / w) * half_height, viewport_.height), out_.y.data() + i);
        store(depth_lanes(z / w), out_.z.data() + i);
        store(w, out_.w.data() + i);
        store(outside(x, y, z, w), out_.outside.data() + i);
    }

    static Floats clamped(Floats value, Floats low, Floats high) {
        return select(value >= low, select(value <= high, value, high), low);
    }
    static Ints snapped(Floats pixels, int size) {
        const Floats limit(static_cast<float>(size));
        return nearest(clamped(pixels, Floats(0), limit) * Floats(float{raster::subpixels}));
    }
    static Ints depth_lanes(Floats z) {
        const Doubles inside = doubles_of(clamped(z, Floats(0), Floats(1)));
        return low_bits(nearest(inside * Doubles(double{raster::depth_far})));
    }

    static Ints outside(Floats x, Floats y, Floats z, Floats w) {
        using raster::ClipPlane;
        return beyond(w + x, ClipPlane::left) | beyond(w - x, ClipPlane::right) |
               beyond(w + y, ClipPlane::bottom) | beyond(w - y, ClipPlane::top) |
               beyond(z, ClipPlane::near) | beyond(w - z, ClipPlane::far);
    }
    static Ints beyond(Floats distance, raster::ClipPlane plane) {
        return select(distance >= Floats(0), Ints(0), Ints(raster::outside_bit(plane)));
    }

    const Placing& placing_;
    raster::Viewport viewport_;
    VertexStreams& out_;
};

}  // namespace scanlight::render::HWY_NAMESPACE
