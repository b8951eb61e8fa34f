#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "mesh/material.h"

namespace scanlight::mesh {

/// Vertices as a structure of arrays: one stream a number, so that a vector's worth of vertices
/// loads at once. A vertex is a distinct position with normal, uv and material: a point on a crease
/// has several, and all faces of a vertex have one material. Object space; normals are unit and
/// finite. Optional streams are empty.
struct Vertices {
    std::vector<float> x, y, z;
    std::vector<float> nx, ny, nz;
    std::vector<float> u, v;              // optional
    std::vector<float> red, green, blue;  // optional, linear; they multiply the diffuse colour

    std::size_t size() const { return x.size(); }
    bool has_colors() const { return !red.empty(); }
    bool has_uvs() const { return !u.empty(); }
    glm::vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
    glm::vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
    glm::vec3 color(std::size_t i) const { return {red[i], green[i], blue[i]}; }
    glm::vec2 uv(std::size_t i) const { return {u[i], v[i]}; }
};

/// A drawable shape: plain arrays, polygons of any size, front faces counter-clockwise.
struct Mesh {
    Vertices vertices;
    std::vector<std::uint32_t> corners;        // indices of vertices
    std::vector<std::uint32_t> face_begin{0};  // faces + 1 of them, into `corners`
    std::vector<glm::vec3> face_normals;       // unit, one a face
    std::vector<float> face_offset;            // normal . p of each face's first corner
    std::vector<glm::vec4> face_u;             // u over each face: its gradient, object space, and
    std::vector<glm::vec4> face_v;             //   its value at the origin; v. Empty without uvs.
    std::vector<std::uint32_t> face_material;  // one a face
    std::vector<std::uint32_t> face_id;        // the face's place in the file, from 0
    std::vector<Material> materials;           // at least one

    std::size_t face_count() const { return face_begin.size() - 1; }
    std::span<const std::uint32_t> face(std::size_t f) const {
        return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
    }
};

}  // namespace scanlight::mesh
