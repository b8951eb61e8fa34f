#pragma once

#include <cstdint>
#include <vector>

namespace scanlight::render {

// Polygons against polygons in exact coordinates: Vatti 1992, "A generic solution to polygon
// clipping", CACM 35(7), by the library Clipper (docs/decisions/0009).

struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Coordinates may go this far from 0.
inline constexpr std::int64_t grid_limit = std::int64_t{1} << 29;

using GridOutline = std::vector<GridPoint>;

/// What lies inside an odd number of the outlines: polygons, and their holes.
using GridRegion = std::vector<GridOutline>;

/// The part of a polygon that no other covers, and the part that any covers. Corners where edges
/// cross are rounded to the grid, which may leave slivers.
GridRegion uncovered(const GridOutline& polygon, const std::vector<GridOutline>& others);
GridRegion covered(const GridOutline& polygon, const std::vector<GridOutline>& others);

/// Positive for outlines that run counter-clockwise, y upwards.
double signed_area(const GridOutline& outline);

}  // namespace scanlight::render
