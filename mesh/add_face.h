#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Adds a face of these corners, without those that repeat their neighbour's point, so that a quad
/// with a side of no length becomes a triangle.
void add_face(PolygonSoup& soup, std::span<const PolygonSoup::Corner> corners);

/// Adds a face of these points.
void add_face(PolygonSoup& soup, std::initializer_list<std::uint32_t> points);

/// Adds columns x rows quads over a lattice of (columns + 1) x (rows + 1) corners, the corner at
/// (column, row) being `corner_at(column, row)`. Counter-clockwise where columns run to the right
/// and rows down.
void add_quads(PolygonSoup& soup, std::uint32_t columns, std::uint32_t rows,
               const std::function<PolygonSoup::Corner(std::uint32_t, std::uint32_t)>& corner_at);

}  // namespace scanlight::mesh
