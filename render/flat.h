#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragments.h"
#include "render/painted.h"
#include "render/placed_mesh.h"

namespace scanlight::render {

/// The mean of a polygon's corners, world space.
glm::vec3 mean_corner(const PlacedMesh& placed, std::size_t face);

/// The mean of the colours at a polygon's corners. Requires vertex colours.
glm::vec3 mean_color(const mesh::Mesh& mesh, std::size_t face);

/// Flat shading: one intensity a polygon, from its geometric normal, lit at the mean of its
/// corners (Bouknight 1970).
template <class Model, Paint paint>
class FlatTechnique {
public:
    static constexpr int attribute_count = 0;
    using Pixel = raster::Rgba;

    FlatTechnique(const PlacedMesh& placed, const Frame& frame, Model model)
        : placed_(placed), frame_(frame), model_(model) {}

    std::array<float, 0> corner(std::size_t, std::uint32_t, Side) const { return {}; }

    /// What the polygon's fragments need beyond their attributes.
    raster::Rgba polygon(std::size_t face, Side side) const {
        const glm::vec3 point = mean_corner(placed_, face);
        const shading::Surface<float> surface{point, placed_.face_normal_seen(face, side),
                                              frame_.view_from(point)};
        const auto& material = painted_by<paint>(placed_.material_of(face),
                                                 [&] { return mean_color(*placed_.mesh, face); });
        return raster::Rgba(illuminate(model_, surface, material, frame_.lighting),
                            placed_.material_of(face).opacity);
    }

    raster::Rgba shade(const raster::Fragment<0>&, const raster::Rgba& color) const {
        return color;
    }

private:
    const PlacedMesh& placed_;
    const Frame& frame_;
    Model model_;
};

}  // namespace scanlight::render
