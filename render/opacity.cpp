#include "render/opacity.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "mesh/part.h"

namespace scanlight::render {

namespace {

/// The numbers of the faces that let light through, or of those that do not.
std::vector<std::uint32_t> faces_of(const Object& object, bool transparent) {
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < object.mesh->face_count(); ++f) {
        if (is_transparent(object, object.mesh->face_material[f]) == transparent)
            faces.push_back(f);
    }
    return faces;
}

void add(const Object& object, bool transparent, SplitScene& split) {
    auto& objects = (transparent ? split.transparent : split.opaque).objects;
    const auto faces = faces_of(object, transparent);
    if (faces.empty()) return;
    objects.push_back(object);
    if (faces.size() == object.mesh->face_count()) return;
    split.parts.push_back(std::make_unique<const mesh::Mesh>(mesh::part(*object.mesh, faces)));
    objects.back().mesh = split.parts.back().get();
    objects.back().silhouettes = nullptr;
}

}  // namespace

bool is_transparent(const Object& object, std::size_t material) {
    const bool has_texture = !object.textures.empty() && object.textures[material].opacity;
    return object.materials[material].opacity < 1.0f || has_texture;
}

bool has_transparent(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [](const Object& object) {
        for (std::size_t i = 0; i < object.materials.size(); ++i) {
            if (is_transparent(object, i)) return true;
        }
        return false;
    });
}

SplitScene split_by_opacity(const Scene& scene) {
    SplitScene split{scene, scene, {}};
    split.opaque.objects.clear();
    split.transparent.objects.clear();
    for (const Object& object : scene.objects) {
        add(object, false, split);
        add(object, true, split);
    }
    return split;
}

}  // namespace scanlight::render
