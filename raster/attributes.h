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

    float at(std::uint32_t vertex, FaceItem face) const {
        if (front == nullptr) return 1.0f;
        return (face & back_flag) == 0 ? front[vertex] * front_scale : back[vertex] * back_scale;
    }
};

/// What is interpolated over the polygons of one mesh.
struct Attributes {
    std::array<AttributeStream, most_attributes> streams;
    int count = 0;
    std::span<const float> w;          // of each vertex, clip space
    bool perspective_correct = false;  // see `project_correct`
};

}  // namespace scanlight::raster
