#pragma once

#include "render/lanes/shade.h"

namespace scanlight::render::HWY_NAMESPACE {

/// Illuminates vertices for Gouraud shading, see `illuminate_vertices`; as many as there are lanes
/// at a time, from each side that is lit.
template <class Model, Paint paint>
class VertexLighter {
public:
    VertexLighter(ObjectPass& pass, const Model& model) : pass_(pass), model_(model) {}

    /// Vertices [begin, end). The largest finite channel among them.
    float light(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; i += lane_count) {
            n_ = static_cast<int>(std::min<std::size_t>(lane_count, end - i));
            light_lanes(i);
        }
        return largest();
    }

private:
    SCANLIGHT_FLATTEN void light_lanes(std::size_t i) {
        const VectorLanes point = vector_at(pass_.vertices.points, i);
        const VectorLanes normal = vector_at(pass_.vertices.normals, i);
        const VectorLanes view = view_from(pass_.frame->viewpoint, point);
        write(light({point, normal, view}, i), pass_.front, i);
        if (pass_.settings.sides == Sides::two) {
            write(light({point, -normal, view}, i), pass_.back, i);
        }
    }

    static VectorLanes vector_at(const VectorStreams& streams, std::size_t i) {
        return {load(streams.x.data() + i), load(streams.y.data() + i), load(streams.z.data() + i)};
    }

    ColorLanes light(const shading::Surface<Floats>& surface, std::size_t i) {
        const auto lit = [&](const auto& material) {
            return illuminate(model_, surface,
                              painted_by<paint>(material, [&] { return vertex_color(i); }),
                              pass_.frame->lighting);
        };
        const auto& materials = pass_.object->materials;
        if (pass_.vertex_material.empty()) return lit(materials.front());
        return by_material(load(pass_.vertex_material.data() + i), first_lanes(n_),
                           [&](std::size_t number) { return lit(materials[number]); });
    }

    Floats some(const std::vector<float>& stream, std::size_t i) const {
        float values[lane_count] = {};
        std::copy_n(stream.data() + i, n_, values);
        return load(values);
    }
    ColorLanes vertex_color(std::size_t i) const {
        const auto& v = pass_.mesh().vertices;
        return {some(v.red, i), some(v.green, i), some(v.blue, i)};
    }

    void write(const ColorLanes& color, VectorStreams& to, std::size_t i) {
        store(color.x, to.x.data() + i);
        store(color.y, to.y.data() + i);
        store(color.z, to.z.data() + i);
        for (const Floats channel : {color.x, color.y, color.z}) {
            const Mask counts = first_lanes(n_) & (channel > largest_) &
                                (channel <= Floats(std::numeric_limits<float>::max()));
            largest_ = select(counts, channel, largest_);
        }
    }

    float largest() const {
        float values[lane_count];
        store(largest_, values);
        return *std::max_element(values, values + lane_count);
    }

    ObjectPass& pass_;
    Model model_;
    int n_ = 0;
    Floats largest_{0};
};

}  // namespace scanlight::render::HWY_NAMESPACE
