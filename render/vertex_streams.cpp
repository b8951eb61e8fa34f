#include "render/vertex_streams.h"

#include <glm/matrix.hpp>

namespace scanlight::render {

Placing placing_of(const glm::dmat4& world_from_object, const Frame& frame) {
    const glm::dmat3 linear(world_from_object);
    return {frame.clip_from_world * world_from_object, world_from_object,
            glm::mat3(glm::transpose(glm::inverse(linear))), glm::determinant(linear) < 0.0};
}

// Not inline: lanes include this file, and what they compile may be used where they do not run.

void VectorStreams::resize(std::size_t n) {
    for (auto* stream : {&x, &y, &z})
        stream->resize(n);
}

void VertexStreams::resize(std::size_t n, bool with_points, bool with_normals) {
    for (auto* stream : {&x, &y, &z, &outside})
        stream->resize(n + raster::most_lanes);
    w.resize(n + raster::most_lanes);
    points.resize(with_points ? n + raster::most_lanes : 0);
    normals.resize(with_normals ? n + raster::most_lanes : 0);
}

}  // namespace scanlight::render
