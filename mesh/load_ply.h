#pragma once

#include <string>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Reads a PLY file, text or binary: positions, normals, texture coordinates and colours of
/// vertices, polygons and their colours, of any scalar types, elements in any order. Integer
/// colours are sRGB, 0 to 255; fractional ones linear. What else it declares is passed over.
/// `name` is for messages. Throws FileError "name:line: reason" or "name: byte N: reason".
PolygonSoup load_ply(std::string_view bytes, const std::string& name);

}  // namespace scanlight::mesh
