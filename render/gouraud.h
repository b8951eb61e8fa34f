#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/fragments.h"
#include "render/placed_mesh.h"
#include "render/undivided.h"

namespace scanlight::render {

/// The intensity of each vertex as it is seen from one side. Linear, not clamped.
std::vector<glm::vec3> illuminate_vertices(const PlacedMesh& placed, const Frame& frame,
                                           const Settings& settings, Side side);

/// The intensities of a mesh's vertices as they are interpolated: divided by `unit`, a power of
/// two, so that the largest finite channel fits the rasterizer's fixed point. Both ways are exact.
struct VertexIntensities {
    std::vector<glm::vec3> front;
    std::vector<glm::vec3> back;  // empty if surfaces are lit on their front only
    float unit = 1.0f;            // at least 1
};

VertexIntensities vertex_intensities(const PlacedMesh& placed, const Frame& frame,
                                     const Settings& settings);

/// The smallest power of two, not below 1, in which `largest` is an attribute.
float unit_for(float largest);

/// The material of each vertex: a vertex belongs to the faces of one material only.
std::vector<std::uint32_t> vertex_materials(const mesh::Mesh& mesh);

/// Gouraud shading: intensities at the vertices, interpolated bilinearly (Gouraud 1971).
/// A constant 1 runs with the colour: in perspective it becomes q, to divide by.
class GouraudTechnique {
public:
    static constexpr int attribute_count = 4;
    using Pixel = raster::Rgba;

    GouraudTechnique(const PlacedMesh& placed, const Frame& frame, const Settings& settings)
        : placed_(placed), intensities_(vertex_intensities(placed, frame, settings)) {}

    /// What the interpolated intensities are multiples of.
    float unit() const { return intensities_.unit; }

    std::array<float, attribute_count> corner(std::size_t, std::uint32_t vertex, Side side) const {
        const auto& [front, back, unit] = intensities_;
        const glm::vec3& color = (side == Side::front ? front : back)[vertex];
        return {color.r, color.g, color.b, 1.0f};
    }

    /// Its opacity.
    float polygon(std::size_t face, Side) const { return placed_.material_of(face).opacity; }

    raster::Rgba shade(const raster::Fragment<attribute_count>& fragment, float opacity) const {
        const auto& a = fragment.attributes;
        const glm::vec3 color = undivided(glm::vec3(a[0], a[1], a[2]), a[3]);
        return raster::Rgba(color * intensities_.unit, opacity);
    }

private:
    const PlacedMesh& placed_;
    VertexIntensities intensities_;
};

}  // namespace scanlight::render
