#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragments.h"
#include "render/painted.h"
#include "render/placed_mesh.h"
#include "render/undivided.h"

namespace scanlight::render {

/// Phong shading: normals interpolated bilinearly, made unit and lit at each pixel (Phong 1975).
/// In perspective a normal needs no division: what is interpolated is the normal times q, which
/// points the same way. Vertex colours do, and carry a constant 1 that becomes q.
template <class Model, Paint paint>
class PhongTechnique {
public:
    static constexpr int attribute_count = paint == Paint::vertices ? 7 : 3;
    using Pixel = raster::Rgba;
    struct Polygon {
        const shading::Material<float>& material;
        glm::vec3 normal;  // where opposed vertex normals cancel, the polygon's own
    };

    PhongTechnique(const PlacedMesh& placed, const Frame& frame, Model model)
        : placed_(placed), frame_(frame), model_(model) {}

    std::array<float, attribute_count> corner(std::size_t, std::uint32_t vertex, Side side) const {
        const glm::vec3 n = placed_.normal_seen(vertex, side);
        if constexpr (paint == Paint::vertices) {
            const glm::vec3 c = placed_.mesh->vertices.color(vertex);
            return {n.x, n.y, n.z, c.r, c.g, c.b, 1.0f};
        } else {
            return {n.x, n.y, n.z};
        }
    }

    Polygon polygon(std::size_t face, Side side) const {
        return {placed_.material_of(face), placed_.face_normal_seen(face, side)};
    }

    raster::Rgba shade(const raster::Fragment<attribute_count>& fragment,
                       const Polygon& polygon) const {
        const auto& a = fragment.attributes;
        const glm::vec3 point = frame_.point_at(fragment.x, fragment.y, fragment.depth);
        const glm::vec3 normal = shading::unit_or(glm::vec3(a[0], a[1], a[2]), polygon.normal);
        const shading::Surface<float> surface{point, normal,
                                              frame_.view_at(fragment.x, fragment.y)};
        const auto& material = painted_by<paint>(
            polygon.material, [&a] { return undivided(glm::vec3(a[3], a[4], a[5]), a[6]); });
        return raster::Rgba(illuminate(model_, surface, material, frame_.lighting),
                            polygon.material.opacity);
    }

private:
    const PlacedMesh& placed_;
    const Frame& frame_;
    Model model_;
};

}  // namespace scanlight::render
