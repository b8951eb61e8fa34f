#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragments.h"
#include "render/painted.h"
#include "render/placed_mesh.h"
#include "render/undivided.h"

namespace scanlight::render {

/// Where a surface's own colour comes from.
enum class Paint { material, vertices };

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
        const glm::vec3 n =
            side == Side::front ? placed_.normals[vertex] : -placed_.normals[vertex];
        if constexpr (paint == Paint::vertices) {
            const glm::vec3 c = placed_.mesh->vertices.color(vertex);
            return {n.x, n.y, n.z, c.r, c.g, c.b, 1.0f};
        } else {
            return {n.x, n.y, n.z};
        }
    }

    Polygon polygon(std::size_t face, Side side) const {
        const glm::vec3 normal = placed_.face_normals[face];
        return {placed_.material_of(face), side == Side::front ? normal : -normal};
    }

    raster::Rgba shade(const raster::Fragment<attribute_count>& fragment,
                       const Polygon& polygon) const {
        const auto& a = fragment.attributes;
        const glm::vec3 point = frame_.point_at(fragment.x, fragment.y, fragment.depth);
        const glm::vec3 normal = shading::unit_or(glm::vec3(a[0], a[1], a[2]), polygon.normal);
        const shading::Surface<float> surface{point, normal, frame_.view_from(point)};
        return raster::Rgba(illuminate(model_, surface, material_at(a, polygon), frame_.lighting),
                            1.0f);
    }

private:
    decltype(auto) material_at(const std::array<float, attribute_count>& a,
                               const Polygon& polygon) const {
        if constexpr (paint == Paint::vertices) {
            return painted(polygon.material, undivided(glm::vec3(a[3], a[4], a[5]), a[6]));
        } else {
            return (polygon.material);
        }
    }

    const PlacedMesh& placed_;
    const Frame& frame_;
    Model model_;
};

}  // namespace scanlight::render
