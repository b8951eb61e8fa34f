#pragma once

#include <cstdint>

#include "mesh/polygon_soup.h"

namespace scanlight::peers {

/// A unit sphere of 4 rings^2 triangles, smooth hills and dales on it up to a sixth of its radius.
mesh::PolygonSoup displaced_sphere(std::uint32_t rings);

/// Waves over a rectangle `aspect` wide and 1 high to each side of the origin, facing +z: quads,
/// none of which turns away from an eye a few units off.
mesh::PolygonSoup wavy_sheet(std::uint32_t columns, std::uint32_t rows, double aspect);

enum class LayerOrder { back_to_front, front_to_back };

/// Upright quads that each fill the picture of an eye at (0, 0, distance) that sees 1 high to each
/// side at z = 0. Every layer has normals of its own, evenly tilted over it: halves of a quad show
/// the same as the whole.
mesh::PolygonSoup full_screen_layers(std::uint32_t count, LayerOrder order, double aspect,
                                     double distance);

}  // namespace scanlight::peers
