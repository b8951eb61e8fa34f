#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/frame.h"
#include "render/scene.h"

namespace scanlight::render {

/// The side of a polygon that faces the eye.
enum class Side { front, back };

/// An object's mesh with its vertices where the camera sees them.
struct PlacedMesh {
    const Object* object;
    const mesh::Mesh* mesh;
    const std::vector<shading::Material<float>>* materials;
    bool mirrored;                        // the placing turns front faces into clockwise ones
    std::vector<glm::vec4> clip;          // position of each vertex, clip space
    std::vector<glm::vec3> points;        // the same, world space
    std::vector<glm::vec3> normals;       // of each vertex, unit, world space
    std::vector<glm::vec3> face_normals;  // unit, world space

    const shading::Material<float>& material_of(std::size_t face) const {
        return (*materials)[mesh->face_material[face]];
    }

    /// The normal of the side that is seen: of a back it is turned round.
    glm::vec3 normal_seen(std::size_t vertex, Side side) const {
        return turned(normals[vertex], side);
    }
    glm::vec3 face_normal_seen(std::size_t face, Side side) const {
        return turned(face_normals[face], side);
    }

private:
    static glm::vec3 turned(const glm::vec3& normal, Side side) {
        return side == Side::front ? normal : -normal;
    }
};

PlacedMesh placed(const Object& object, const Frame& frame);

}  // namespace scanlight::render
