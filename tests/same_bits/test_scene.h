#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "raster/project.h"
#include "render/scene.h"

namespace scanlight::same_bits {

/// A scene with its meshes, and how large and by which settings it is drawn. Built of arithmetic
/// that has the same bits everywhere, from numbers that have them too.
struct TestScene {
    raster::Viewport size;
    render::Settings settings;
    render::Scene scene;
    std::vector<std::unique_ptr<const mesh::Mesh>> meshes;

    /// The mesh moves in; it may be placed many times.
    const mesh::Mesh& keep(mesh::Mesh mesh) {
        return *meshes.emplace_back(std::make_unique<const mesh::Mesh>(std::move(mesh)));
    }
};

/// A scene that is built when it is wanted. Names are unique and hold no blanks.
struct NamedScene {
    std::string name;
    std::function<TestScene()> make;
};
using NamedScenes = std::vector<NamedScene>;

/// Built-in shapes under every mixture of the settings.
NamedScenes mixed_scenes();

/// One scene for each thing that has a path of its own or could go wrong.
NamedScenes special_scenes();

/// Random polygons of all sizes and kinds.
NamedScenes soup_scenes();

/// Shadows of several objects in several lights.
NamedScenes shadow_scenes();

/// Every kind of texture, on every attribute.
NamedScenes texture_scenes();

/// Transparent surfaces, some of which intersect.
NamedScenes glass_scenes();

/// In the light of an environment.
NamedScenes room_scenes();
/// The models that know more of a surface than colours, on surfaces of all kinds.
NamedScenes model_scenes();

/// All of them.
NamedScenes all_scenes();

}  // namespace scanlight::same_bits
