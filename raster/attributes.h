#pragma once

#include <array>
#include <span>

#include "raster/polygon_streams.h"

namespace scanlight::raster {

inline constexpr int most_attributes = 9;

/// An attribute of all vertices of a mesh, for polygons seen from the front and from the back, each
/// times its scale. Null stands for 1.
struct AttributeStream {
    const float* front = nullptr;
    const float* back = nullptr;
    float front_scale = 1.0f;
    float back_scale = 1.0f;
};

/// One side of an `AttributeStream`, which is asked for without a branch.
class AttributeSide {
public:
    AttributeSide() = default;
    AttributeSide(const AttributeStream& stream, FaceItem face) {
        if (stream.front == nullptr) return;
        const bool is_front = (face & back_flag) == 0;
        values_ = is_front ? stream.front : stream.back;
        scale_ = is_front ? stream.front_scale : stream.back_scale;
        index_mask_ = ~0u;
    }

    float operator[](std::uint32_t vertex) const { return values_[vertex & index_mask_] * scale_; }

private:
    static constexpr float one = 1.0f;

    const float* values_ = &one;
    float scale_ = 1.0f;
    std::uint32_t index_mask_ = 0;
};

/// What is interpolated over the polygons of one mesh.
struct Attributes {
    std::array<AttributeStream, most_attributes> streams;
    int count = 0;
    std::span<const float> w;          // of each vertex, clip space
    bool perspective_correct = false;  // see `project_correct`
};

}  // namespace scanlight::raster
