#pragma once

#include <string>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Whether the bytes are a binary STL file: 80 bytes of anything, a count, and exactly so many
/// triangles, give or take a tail too short to hide one. A text file cannot pass: its four bytes
/// there would count 50 GB of triangles or more.
bool is_binary_stl(std::string_view bytes);

/// Reads an STL file, text or binary. Corners with equal bits become one point; normals and
/// attribute bytes are passed over. A binary file whose length belies its count is refused.
/// `name` is for messages. Throws FileError "name:line: reason" or "name: byte N: reason".
PolygonSoup load_stl(std::string_view bytes, const std::string& name);

}  // namespace scanlight::mesh
