#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/fragments.h"
#include "render/placed_mesh.h"

namespace scanlight::render {

/// Flat shading: one intensity a polygon, from its geometric normal, lit at the mean of its
/// corners (Bouknight 1970).
class FlatTechnique {
public:
    static constexpr int attribute_count = 0;
    using Pixel = raster::Rgba;

    FlatTechnique(const PlacedMesh& placed, const Frame& frame, const Settings& settings)
        : placed_(placed), frame_(frame), settings_(settings) {}

    std::array<float, 0> corner(std::size_t, std::uint32_t, Side) const { return {}; }

    /// What the polygon's fragments need beyond their attributes.
    raster::Rgba polygon(std::size_t face, Side side) const;

    raster::Rgba shade(const raster::Fragment<0>&, const raster::Rgba& color) const {
        return color;
    }

private:
    const PlacedMesh& placed_;
    const Frame& frame_;
    const Settings& settings_;
};

}  // namespace scanlight::render
