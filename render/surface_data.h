#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragments.h"
#include "render/placed_mesh.h"
#include "shading/reflectance.h"

namespace scanlight::render {

/// All polygons in one colour, unlit: for what only depth, or the way they face, is wanted of.
class PlainTechnique {
public:
    static constexpr int attribute_count = 0;
    using Pixel = raster::Rgba;
    struct Nothing {};

    explicit PlainTechnique(const raster::Rgba& color) : color_(color) {}

    std::array<float, 0> corner(std::size_t, std::uint32_t, Side) const { return {}; }
    Nothing polygon(std::size_t, Side) const { return {}; }
    raster::Rgba shade(const raster::Fragment<0>&, Nothing) const { return color_; }

private:
    raster::Rgba color_;
};

/// Which polygon a pixel shows: its place in the mesh file plus 1, counted on from one object to
/// the next. 0 is the background.
class IdTechnique {
public:
    static constexpr int attribute_count = 0;
    using Pixel = std::uint32_t;

    IdTechnique(const PlacedMesh& placed, std::uint32_t first_id)
        : placed_(placed), first_id_(first_id) {}

    std::array<float, 0> corner(std::size_t, std::uint32_t, Side) const { return {}; }
    std::uint32_t polygon(std::size_t face, Side) const {
        return first_id_ + placed_.mesh->face_id[face];
    }
    std::uint32_t shade(const raster::Fragment<0>&, std::uint32_t id) const { return id; }

private:
    const PlacedMesh& placed_;
    std::uint32_t first_id_;
};

/// The item buffer (Weghorst, Hooper & Greenberg 1984, "Improved computational methods for ray
/// tracing", TOG 3(1)): which face a pixel shows, its place in the mesh plus `first_item`. 0 is the
/// background.
class ItemTechnique {
public:
    static constexpr int attribute_count = 0;
    using Pixel = std::uint32_t;

    explicit ItemTechnique(std::uint32_t first_item) : first_item_(first_item) {}

    std::array<float, 0> corner(std::size_t, std::uint32_t, Side) const { return {}; }
    std::uint32_t polygon(std::size_t face, Side) const {
        return first_item_ + static_cast<std::uint32_t>(face);
    }
    std::uint32_t shade(const raster::Fragment<0>&, std::uint32_t item) const { return item; }

private:
    std::uint32_t first_item_;
};

/// The unit normal that Phong shading lights at a pixel; world space. Zero is the background.
class NormalTechnique {
public:
    static constexpr int attribute_count = 3;
    using Pixel = glm::vec3;

    explicit NormalTechnique(const PlacedMesh& placed) : placed_(placed) {}

    std::array<float, 3> corner(std::size_t, std::uint32_t vertex, Side side) const {
        const glm::vec3 n = placed_.normal_seen(vertex, side);
        return {n.x, n.y, n.z};
    }
    glm::vec3 polygon(std::size_t face, Side side) const {
        return placed_.face_normal_seen(face, side);
    }
    glm::vec3 shade(const raster::Fragment<3>& fragment, const glm::vec3& face_normal) const {
        const auto& a = fragment.attributes;
        return shading::unit_or(glm::vec3(a[0], a[1], a[2]), face_normal);
    }

private:
    const PlacedMesh& placed_;
};

/// The share of light that a smooth surface of the pixel's material would mirror into the eye: rho
/// of Fresnel's equations, at the angle between N and V.
class FresnelTechnique {
public:
    static constexpr int attribute_count = 3;
    using Pixel = raster::Rgba;
    struct Polygon {
        const shading::Reflectance& reflectance;
        glm::vec3 normal;
    };

    FresnelTechnique(const PlacedMesh& placed, const Frame& frame)
        : placed_(placed), normals_(placed), frame_(frame) {}

    std::array<float, 3> corner(std::size_t face, std::uint32_t vertex, Side side) const {
        return normals_.corner(face, vertex, side);
    }
    Polygon polygon(std::size_t face, Side side) const {
        return {placed_.material_of(face).facets.reflectance, normals_.polygon(face, side)};
    }
    raster::Rgba shade(const raster::Fragment<3>& fragment, const Polygon& polygon) const {
        const glm::vec3 N = normals_.shade(fragment, polygon.normal);
        const glm::vec3 V = frame_.view_at(fragment.x, fragment.y);
        const float cosine = shading::positive_part(shading::dot(N, V));
        return raster::Rgba(shading::reflectance_at(cosine, polygon.reflectance), 1.0f);
    }

private:
    const PlacedMesh& placed_;
    NormalTechnique normals_;
    const Frame& frame_;
};

}  // namespace scanlight::render
