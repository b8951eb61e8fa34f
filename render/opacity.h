#pragma once

#include <memory>
#include <vector>

#include "render/scene.h"

namespace scanlight::render {

/// Whether light comes through the surfaces of one of an object's materials.
bool is_transparent(const Object& object, std::size_t material);
bool has_transparent(const Scene& scene);

/// What one of an object's faces leaves of light that comes through it.
inline const glm::vec3& filter_of(const Object& object, std::size_t face) {
    const auto& materials = object.materials;
    return materials[materials.size() == 1 ? 0 : object.mesh->face_material[face]].filter;
}

/// A scene's objects, those that let light through apart from those that do not. An object of both
/// kinds is in both, each time with the faces that belong there.
struct SplitScene {
    Scene opaque;
    Scene transparent;
    std::vector<std::unique_ptr<const mesh::Mesh>> parts;  // of such objects
};

SplitScene split_by_opacity(const Scene& scene);

}  // namespace scanlight::render
