#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "raster/clip.h"
#include "raster/project.h"
#include "render/placed_mesh.h"
#include "render/scene.h"

namespace scanlight::render {

/// What becomes of a polygon on its way to the screen.
enum class Fate { outside, culled, seen };

template <int N>
struct ScreenPolygon {
    Fate fate = Fate::outside;
    Side side = Side::front;  // the side whose corners and whose light are to be used
    std::vector<raster::ScreenVertex<N>> corners;
};

/// The way of a mesh's polygons to the screen, the same for each technique: corners gathered,
/// clipped, projected, culled by the way they face on the screen. A Technique says what its pixels
/// are:
///
///     static constexpr int attribute_count;
///     using Pixel;
///     std::array<float, attribute_count> corner(face, vertex, Side);   what to interpolate
///     auto polygon(face, Side);                                        what is the same all over
///     Pixel shade(const Fragment<attribute_count>&, polygon);
template <class Technique>
class ScreenPolygons {
public:
    static constexpr int N = Technique::attribute_count;

    ScreenPolygons(const PlacedMesh& placed, const Technique& technique, const Frame& frame,
                   const Settings& settings)
        : placed_(placed), technique_(technique), frame_(frame), settings_(settings) {}

    ScreenPolygon<N> operator[](std::size_t face) const {
        ScreenPolygon<N> result{Fate::outside, Side::front, projected(face, Side::front)};
        if (result.corners.size() < 3) return result;
        const Side facing = facing_side(result.corners);
        result.fate = culled(facing) ? Fate::culled : Fate::seen;
        if (result.fate == Fate::seen && facing == Side::back && settings_.sides == Sides::two) {
            result.side = Side::back;
            if (N > 0) result.corners = projected(face, Side::back);
        }
        return result;
    }

private:
    std::vector<raster::ScreenVertex<N>> projected(std::size_t face, Side side) const {
        const auto clipped = raster::clip(gathered(face, side));
        return settings_.perspective == Perspective::correct
                   ? raster::project_correct(clipped, frame_.viewport)
                   : raster::project_affine(clipped, frame_.viewport);
    }

    std::vector<raster::ClipVertex<N>> gathered(std::size_t face, Side side) const {
        const auto corners = placed_.mesh->face(face);
        std::vector<raster::ClipVertex<N>> polygon;
        polygon.reserve(corners.size());
        for (const std::uint32_t vertex : corners) {
            polygon.push_back({placed_.clip[vertex], technique_.corner(face, vertex, side)});
        }
        return polygon;
    }

    Side facing_side(const std::vector<raster::ScreenVertex<N>>& corners) const {
        const bool counter_clockwise = raster::signed_area(corners) >= 0;
        return counter_clockwise != placed_.mirrored ? Side::front : Side::back;
    }

    bool culled(Side facing) const {
        return (settings_.cull == Cull::back && facing == Side::back) ||
               (settings_.cull == Cull::front && facing == Side::front);
    }

    const PlacedMesh& placed_;
    const Technique& technique_;
    const Frame& frame_;
    const Settings& settings_;
};

}  // namespace scanlight::render
