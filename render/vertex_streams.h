#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "raster/project.h"
#include "raster/streams.h"
#include "render/frame.h"
#include "render/scene.h"

namespace scanlight::render {

/// How one object's vertices get into the world and onto the screen.
struct Placing {
    glm::dmat4 clip_from_object;
    glm::dmat4 world_from_object;
    glm::mat3 normals_from_object;
    bool mirrored;  // turns front faces into clockwise ones
};

Placing placing_of(const glm::dmat4& world_from_object, const Frame& frame);

/// Three streams of vectors.
struct VectorStreams {
    std::vector<float> x, y, z;

    void resize(std::size_t n);
    std::size_t bytes() const { return raster::bytes_held(x, y, z); }
};

/// What is worked out of each vertex before anything is drawn: structure of arrays.
struct VertexStreams {
    std::vector<std::int32_t> x, y, z;  // on the screen; of those outside the view volume no use
    std::vector<std::int32_t> outside;  // see `raster::PolygonStreams`
    std::vector<float> w;               // clip space
    VectorStreams points;               // world space; if wanted
    VectorStreams normals;              // unit, world space; if wanted

    /// For n vertices, and a vector's more.
    void resize(std::size_t n, bool with_points, bool with_normals);
    std::size_t bytes() const {
        return raster::bytes_held(x, y, z, outside, w) + points.bytes() + normals.bytes();
    }
};

}  // namespace scanlight::render
