#include "render/placed_mesh.h"

#include <cassert>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/transform.h"

namespace scanlight::render {

PlacedMesh placed(const Object& object, const Frame& frame) {
    const mesh::Mesh& mesh = *object.mesh;
    assert(object.materials.size() == mesh.materials.size());
    const glm::dmat3 linear(object.world_from_object);
    const glm::dmat4 clip_from_object = frame.clip_from_world * object.world_from_object;
    const glm::mat3 normals_from_object(glm::transpose(glm::inverse(linear)));

    PlacedMesh result{&object, &mesh, &object.materials, glm::determinant(linear) < 0.0, {}, {},
                      {},      {}};
    const std::size_t count = mesh.vertices.size();
    result.clip.reserve(count);
    result.points.reserve(count);
    result.normals.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        // In double: far from the origin the camera's place and the vertex's cancel.
        const glm::dvec3 position(mesh.vertices.position(i));
        result.clip.emplace_back(transformed_point(clip_from_object, position));
        result.points.emplace_back(transformed_point(object.world_from_object, position));
        result.normals.push_back(transformed_normal(normals_from_object, mesh.vertices.normal(i)));
    }
    result.face_normals.reserve(mesh.face_count());
    for (const glm::vec3& normal : mesh.face_normals) {
        result.face_normals.push_back(transformed_normal(normals_from_object, normal));
    }
    return result;
}

}  // namespace scanlight::render
