#pragma once

#include <string>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Reads a mesh file: OBJ with its MTL, PLY, OFF or STL, told apart by content, then by ending.
/// `path` "-" reads standard input. Throws FileError: cannot be opened, not a regular file or
/// pipe, not a known format, or malformed. Never returns a part of a file.
PolygonSoup load(const std::string& path);

}  // namespace scanlight::mesh
