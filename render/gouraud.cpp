#include "render/gouraud.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/painted.h"

namespace scanlight::render {

namespace {

float largest_finite(const std::vector<glm::vec3>& colors) {
    float largest = 0.0f;
    for (const glm::vec3& color : colors) {
        for (const float channel : {color.r, color.g, color.b}) {
            if (std::isfinite(channel)) largest = std::max(largest, channel);
        }
    }
    return largest;
}

std::vector<glm::vec3> divided(std::vector<glm::vec3> colors, float unit) {
    for (glm::vec3& color : colors)
        color /= unit;
    return colors;
}

}  // namespace

float unit_for(float largest) {
    float unit = 1.0f;
    while (largest / unit > raster::attribute_limit)
        unit *= 2.0f;
    return unit;
}

std::vector<std::uint32_t> vertex_materials(const mesh::Mesh& mesh) {
    std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f))
            result[vertex] = mesh.face_material[f];
    }
    return result;
}

std::vector<glm::vec3> illuminate_vertices(const PlacedMesh& placed, const Frame& frame,
                                           const Settings& settings, Side side) {
    const mesh::Mesh& mesh = *placed.mesh;
    const auto materials = vertex_materials(mesh);
    std::vector<glm::vec3> colors(mesh.vertices.size());
    with_model(settings, [&](auto model) {
        with_paint(mesh, [&](auto paint) {
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const shading::Surface<float> surface{placed.points[i], placed.normal_seen(i, side),
                                                      frame.view_from(placed.points[i])};
                const auto& material = painted_by<paint>((*placed.materials)[materials[i]],
                                                         [&] { return mesh.vertices.color(i); });
                colors[i] = illuminate(model, surface, material, frame.lighting);
            }
        });
    });
    return colors;
}

VertexIntensities vertex_intensities(const PlacedMesh& placed, const Frame& frame,
                                     const Settings& settings) {
    VertexIntensities result;
    result.front = illuminate_vertices(placed, frame, settings, Side::front);
    if (settings.sides == Sides::two) {
        result.back = illuminate_vertices(placed, frame, settings, Side::back);
    }
    result.unit = unit_for(std::max(largest_finite(result.front), largest_finite(result.back)));
    result.front = divided(std::move(result.front), result.unit);
    result.back = divided(std::move(result.back), result.unit);
    return result;
}

}  // namespace scanlight::render
