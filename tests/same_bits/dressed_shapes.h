#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

#include "tests/render/scenes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/materials.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

/// A shape alone, in materials that differ and three lights.
inline TestScene shape_scene(mesh::Mesh mesh, raster::Viewport size,
                             const render::Settings& settings) {
    TestScene test{size, settings, {}, {}};
    const mesh::Mesh& kept = test.keep(std::move(mesh));
    test.scene = render::scene_of({{&kept, several_materials(kept.materials.size())}}, {{}, size});
    test.scene.lighting = lighting(2);
    return test;
}

/// Colours by place, so that they change along each edge.
inline mesh::Mesh colored_shape(std::string_view shape) {
    mesh::PolygonSoup soup = mesh::shape(shape);
    for (const glm::vec3& p : soup.positions)
        soup.colors.push_back(0.5f + 0.25f * p);
    return mesh::build(soup).mesh;
}

/// Face by face one material after the other.
inline mesh::Mesh motley_shape(std::string_view shape, std::uint32_t materials) {
    mesh::PolygonSoup soup = mesh::shape(shape);
    soup.materials.resize(materials);
    for (std::uint32_t face = 0; face < soup.face_count(); ++face)
        soup.face_material.push_back(face % materials);
    return mesh::build(soup).mesh;
}

}  // namespace scanlight::same_bits
