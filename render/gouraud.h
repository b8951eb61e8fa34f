#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/fragments.h"
#include "render/placed_mesh.h"
#include "render/undivided.h"

namespace scanlight::render {

/// The intensity of each vertex as it is seen from one side. Linear; where they are interpolated
/// channels above 4 count as 4, the range of the rasterizer's fixed point.
std::vector<glm::vec3> illuminate_vertices(const PlacedMesh& placed, const Frame& frame,
                                           const Settings& settings, Side side);

/// Gouraud shading: intensities at the vertices, interpolated bilinearly (Gouraud 1971).
/// A constant 1 runs with the colour: in perspective it becomes q, to divide by.
class GouraudTechnique {
public:
    static constexpr int attribute_count = 4;
    using Pixel = raster::Rgba;
    struct Nothing {};

    GouraudTechnique(const PlacedMesh& placed, const Frame& frame, const Settings& settings)
        : front_(illuminate_vertices(placed, frame, settings, Side::front)),
          back_(settings.sides == Sides::two
                    ? illuminate_vertices(placed, frame, settings, Side::back)
                    : std::vector<glm::vec3>()) {}

    std::array<float, attribute_count> corner(std::size_t, std::uint32_t vertex, Side side) const {
        const glm::vec3& color = (side == Side::front ? front_ : back_)[vertex];
        return {color.r, color.g, color.b, 1.0f};
    }

    Nothing polygon(std::size_t, Side) const { return {}; }

    raster::Rgba shade(const raster::Fragment<attribute_count>& fragment, Nothing) const {
        const auto& a = fragment.attributes;
        return raster::Rgba(undivided(glm::vec3(a[0], a[1], a[2]), a[3]), 1.0f);
    }

private:
    std::vector<glm::vec3> front_;
    std::vector<glm::vec3> back_;
};

}  // namespace scanlight::render
